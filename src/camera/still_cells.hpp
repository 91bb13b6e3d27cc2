// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "camera/road_plane_alignment.hpp"

namespace lanefuse {

/// Finds the cells of an image that show what is fixed to the car (the bonnet, reflections in the windscreen)
/// and not the road. Left in, they would hold the motion at zero.
class StillCells {
 public:
  explicit StillCells(std::size_t cells) : stillness_(cells, 0) {}

  /// Judges the cells that `pair` believes: what fits unmoved although its texture would tell any motion
  /// forward. `jacobians` are those of the warp without motion.
  void judge(const RoadPair& pair, const CameraPose& pose,
             const std::vector<RoadPlaneWarp::Jacobian>& jacobians);

  /// Unmoved in this pair of images, or mostly so in those before.
  [[nodiscard]] bool still(std::size_t cell) const { return stillness_[cell] > kMemory; }

  /// Nearly all texture that would tell a motion forward is still: so the car is.
  [[nodiscard]] bool car_stands() const { return car_stands_; }

 private:
  static constexpr float kMemory = 0.25F;  ///< what one image counts for
  std::vector<float> stillness_;
  bool car_stands_ = false;
};

/// Which share of a cell's texture would tell a motion forward, in [0, 1]: little on lines along the road.
double forward_share(const CellMatch& match, const RoadPlaneWarp::Jacobian& jacobian);

/// Which share of the texture that tells a motion forward fits, in [-1, 1]; by chance 0.
double forward_fit(const std::vector<CellMatch>& matches,
                   const std::vector<RoadPlaneWarp::Jacobian>& jacobians);

}  // namespace lanefuse
