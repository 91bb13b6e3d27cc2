// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "road/paint_update.hpp"
#include "road/road_state.hpp"

namespace lanefuse {

/// Remembers paint that is of no known line until it is certain that it is a line of its own, and lets lines
/// go that nothing tells of any more.
class LineBirths {
 public:
  explicit LineBirths(const RoadConfig& config) : config_(config) {}

  void clear() { candidates_.clear(); }

  /// Stray paint of one frame.
  void gather(std::span<const StrayPaint> strays, const RoadState& state);
  /// The car moved aside by `aside` [m], and along by `along`.
  void move(double aside, double along);
  void found_lines(RoadState& state);
  void forget_lines(RoadState& state) const;

 private:
  struct Candidate {
    double lateral = 0;
    double weight = 0;
    double frames = 0;
    double begin = 0;  ///< stations from the car between which it was seen
    double end = 0;
    LineLabel label = kNoLabel;
    bool in_frame = false;
  };
  static bool is_outermost(const KnownLine& line, const RoadState& state);
  [[nodiscard]] bool is_line(const Candidate& candidate, const RoadState& state) const;

  RoadConfig config_;
  std::vector<Candidate> candidates_;
};

}  // namespace lanefuse
