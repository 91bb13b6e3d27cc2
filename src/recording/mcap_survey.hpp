// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "recording/mcap_block.hpp"
#include "recording/mcap_damage.hpp"
#include "recording/mcap_input_file.hpp"

namespace lanefuse::mcap {

/// Where a data section ends, and the CRC of all bytes before.
struct DataSectionEnd {
  std::uint64_t offset = 0;
  std::uint32_t crc = 0;  ///< 0: absent
};

/// What is where in a file: everything but the messages and the contents of attachments.
struct Survey {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::vector<Metadata> metadata;
  std::vector<AttachmentIndex> attachments;
  std::vector<Block> blocks;  ///< that have messages, in the order of the file
  std::optional<DataSectionEnd> data_end;
  Damage damage;
};

/// Walks the file from record to record. Chunks that the summary describes are passed by; others are unpacked
/// once to see what is in them; and where a record is broken, the walk goes on at the next sound chunk.
Survey survey(const InputFile& file);

}  // namespace lanefuse::mcap
