// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "recording/mcap_records.hpp"
#include "recording/mcap_writer.hpp"

namespace lanefuse::mcap {

/// What the specification calls it: "", "lz4" (LZ4 frames) or "zstd" (Zstandard frames).
std::string to_string(Compression compression);

Bytes compress(Compression compression, std::span<const std::byte> bytes);

/// The bytes of `packed`, which must be exactly `size` of them; nothing where they are not, or the
/// compression is unknown. The caller has checked `size` against the limits.
std::optional<Bytes> decompress(const std::string& compression, std::span<const std::byte> packed,
                                std::uint64_t size);

}  // namespace lanefuse::mcap
