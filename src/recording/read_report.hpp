// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace lanefuse {

/// What of a recording could not be read. A damaged file gives what is sound; whoever reads it decides what
/// the rest means. Complete once the reader has come to the end.
struct ReadReport {
  std::string first_problem;           ///< what and where, of the first thing lost; empty if nothing was
  std::uint64_t chunks_lost = 0;       ///< chunks that failed their CRC or were cut off
  std::uint64_t records_lost = 0;      ///< records outside chunks
  std::uint64_t messages_refused = 0;  ///< sound by their CRC, but not what their schema says
  std::uint64_t bytes_skipped = 0;     ///< stretches without a readable record

  [[nodiscard]] bool complete() const { return first_problem.empty(); }
};

}  // namespace lanefuse
