// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "core/lane_estimate.hpp"

namespace lanefuse {

/// Counts how often an estimate had to begin anew: its status fell from OK to INVALID, or the ego lane came
/// back, or went over, to two boundaries that both are new. What falls and then comes back anew is one reset;
/// a lane change keeps one boundary, and is none.
class ResetCounter {
 public:
  /// Estimates come in order of time.
  void add(const LaneEstimate& estimate);
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  struct Edges {
    std::uint64_t left = 0;
    std::uint64_t right = 0;
  };

  std::uint64_t count_ = 0;
  EstimateStatus last_status_ = EstimateStatus::invalid;
  std::optional<Edges> last_edges_;  // of the last ego lane; nothing after a fall that was counted
};

}  // namespace lanefuse
