// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/mcap_input_file.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse::mcap {

/// A piece of a file that is read at once: a chunk, or a run of records outside chunks.
struct Block {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;      ///< in the file
  std::uint64_t start_time = 0;  ///< the earliest message's [ns]
  std::uint64_t size = 0;        ///< of its records in memory
  bool is_chunk = true;
  std::vector<std::uint16_t> channels;  ///< that have messages in it
};

/// Records, or why there are none.
struct LoadedBlock {
  Bytes records;
  std::string problem;
};

/// The records of the chunk at `head`: lengths checked against the limits, unpacked, checked against its CRC.
LoadedBlock load_chunk(const InputFile& file, const RecordHead& head);

LoadedBlock load_block(const InputFile& file, const Block& block);

}  // namespace lanefuse::mcap
