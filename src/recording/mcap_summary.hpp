// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "recording/mcap_block.hpp"
#include "recording/mcap_damage.hpp"
#include "recording/mcap_input_file.hpp"

namespace lanefuse::mcap {

/// What the end of a file says about it.
struct Summary {
  std::uint64_t footer_offset = 0;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::map<std::uint64_t, Block> chunks;  ///< by offset: those whose channels and schemas are all above
};

/// The file's summary, empty if it has none; nothing where the end of the file is missing or altered (which
/// is noted) or is larger than is kept in memory: then the file must be scanned.
std::optional<Summary> read_summary(const InputFile& file, Damage& damage);

}  // namespace lanefuse::mcap
