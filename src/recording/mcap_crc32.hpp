// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lanefuse::mcap {

/// CRC-32 (polynomial 0x04C11DB7 reflected, as in zlib and Ethernet) of `bytes`, going on from `before`, the
/// CRC of all that came before them.
std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0);

}  // namespace lanefuse::mcap
