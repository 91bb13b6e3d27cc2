// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "recording/lanes_reader.hpp"

namespace lanefuse {

/// One cycle that the report shows.
struct Highlight {
  LaneRecord record;
  double seconds = 0;          ///< since the first cycle
  bool most_switched = false;  ///< it has the most switched-off edges of all
};

/// Picks the cycles that the report shows, in one pass: three spread over the drive, and the one with the
/// most switched-off edges.
class Highlights {
 public:
  /// The drive lasts from `begin` to `end`.
  Highlights(Time begin, Time end);

  /// Records come in order of time and need no fused features: `complete` adds them to those that are kept.
  void add(const LaneRecord& record, const std::function<void(LaneRecord&)>& complete);
  [[nodiscard]] std::optional<Time> first() const { return first_; }
  /// In order of time, each once.
  [[nodiscard]] std::vector<Highlight> chosen() const;

 private:
  std::vector<Time> due_;
  std::size_t taken_ = 0;  // of due_
  std::optional<Time> first_;
  std::vector<Highlight> spread_;
  std::optional<Highlight> most_switched_;
  std::ptrdiff_t most_switched_count_ = 0;
};

}  // namespace lanefuse
