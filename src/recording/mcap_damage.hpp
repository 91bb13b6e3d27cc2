// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace lanefuse::mcap {

/// What of a file could not be trusted or read. Losses are counted, never hidden.
struct Damage {
  bool any = false;
  std::string first_place;          ///< "byte 605: the chunk's CRC does not match"
  std::uint64_t chunks_lost = 0;    ///< chunks of which no message was given
  std::uint64_t records_lost = 0;   ///< records outside chunks that could not be understood
  std::uint64_t bytes_skipped = 0;  ///< stretches of the file without a readable record

  std::uint64_t first_byte = 0;

  /// Notes damage at `byte` of the file; the first place is the one nearest to the file's beginning.
  void note(std::uint64_t byte, const std::string& what);
};

}  // namespace lanefuse::mcap
