// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "camera/edge_search.hpp"
#include "camera/lane_filter.hpp"
#include "camera/paint_bars.hpp"

namespace lanefuse {

struct LaneAcquisitionConfig {
  double nearest = 7;           ///< [m] of the first row
  double farthest = 45;         ///< [m] of the last row
  double reach = 5;             ///< [m] to either side
  double lane_width_min = 2.5;  ///< [m]
  double lane_width_max = 4.5;  ///< [m]
  double contrast_min = 7;      ///< [grey levels]
  double votes_min = 5;         ///< rows that must agree on each of the two markings
};

/// Finds the ego lane in one image from scratch: bars of all rows vote, for every heading, curvature and
/// pitch in question, for where they cross the car's own axle; the sharpest pair of peaks around the car that
/// is a lane's width apart is the lane.
class LaneAcquisition {
 public:
  explicit LaneAcquisition(const LaneAcquisitionConfig& config);

  /// A first guess, with a covariance that says how rough it is.
  std::optional<Gaussian<LaneState::kSize>> find(const EdgeScene& scene);

 private:
  static constexpr int kBins = 128;
  struct Vote {
    float x;
    float y;
    float weight;
  };
  struct Pair {
    double score = 0;
    double left = 0;   ///< [m]
    double right = 0;  ///< [m]
  };

  LaneAcquisitionConfig config_;
  PaintBarFinder finder_;
  std::vector<RoadSight::Ray> rays_;
  std::vector<Vote> votes_;
  std::array<float, kBins> bins_{};

  void collect(const EdgeScene& scene);
  void land(const RoadSight& sight, double pitch);
  [[nodiscard]] Pair best_pair(double heading, double curvature);
  [[nodiscard]] double bin_width() const { return 2 * config_.reach / kBins; }
};

}  // namespace lanefuse
