// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "recording/mcap_input_file.hpp"

namespace lanefuse::mcap {

/// The first sound chunk of a damaged file that begins at `begin` or later: one that has a CRC which matches.
/// Where the record before it is broken, nothing else says where it is.
std::optional<RecordHead> find_chunk(const InputFile& file, std::uint64_t begin);

}  // namespace lanefuse::mcap
