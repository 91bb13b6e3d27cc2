// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "camera/edge_search.hpp"
#include "camera/lane_filter.hpp"
#include "camera/paint_bars.hpp"

namespace lanefuse {

/// How wide the lane next to the ego lane appears, between the inner edges of its two markings.
struct NeighbourWidth {
  double width = 0;  ///< [m]
  double sigma = 0;  ///< [m]
};

/// Measures how wide a neighbour lane looks in one image: the bars beyond the ego lane's marking vote for
/// their distance from it. It is not tracked: it is there to tell how the camera is rolled.
class NeighbourMarkings {
 public:
  /// `side`: of the ego lane; the widths [m] that are searched.
  std::optional<NeighbourWidth> measure(const EdgeScene& scene, const LaneState::Vector& state, Side side);

 private:
  static constexpr int kBins = 48;
  static constexpr std::size_t kMost = 200;
  PaintBarFinder finder_;
  std::array<double, kMost> widths_{};
  std::array<double, kBins> bins_{};

  std::size_t collect(const EdgeScene& scene, const LaneState::Vector& state, Side side);
};

}  // namespace lanefuse
