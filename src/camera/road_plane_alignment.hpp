// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "camera/reduced_image.hpp"
#include "camera/road_plane_warp.hpp"
#include "core/kalman.hpp"

namespace lanefuse {

/// What an image shows of the road, freed of brightness and shadows' depth: each pixel against the mean and
/// the contrast around it, in [-3, 3]. Contrast below a few grey levels counts as none.
NumberImage road_texture(const NumberImage& brightness);
/// The same picture less sharp, for the first steps from a poor guess.
NumberImage smoothed(const NumberImage& texture);

/// How well one cell of the image now fits the image before, under a warp.
struct CellMatch {
  bool seen = false;                                    ///< in both images
  float energy = 0;                                     ///< of the texture now: the mean square
  float correlation = 0;                                ///< in [-1, 1]
  float residual = 0;                                   ///< mean square of the difference
  Eigen::Matrix2f curvature = Eigen::Matrix2f::Zero();  ///< sum of gradient gradient'
  Eigen::Vector2f slope = Eigen::Vector2f::Zero();      ///< sum of gradient x difference

  [[nodiscard]] bool has_texture() const { return seen && energy > 0.02F; }  ///< more than noise
};

/// Two consecutive images' textures and the cells that may be believed.
struct RoadPair {
  const RoadPlaneWarp& warp;
  const NumberImage& before;
  const NumberImage& now;
  const std::vector<std::uint8_t>& believed;  ///< a cell each, 0: leave it out
};

/// Matches all believed cells through the corners' places in the image before.
std::vector<CellMatch> match_cells(const RoadPair& pair, const std::vector<RoadPlaneWarp::Node>& corners);

struct RoadPlaneAlignment {
  Gaussian<PlaneMotion::kSize> motion;
  std::vector<CellMatch> matches;  ///< under that motion
};

/// How much each pixel differs from the image before, moved as the road; 0 where there is no road. Little
/// where the road is, much where something stands on it.
NumberImage plane_residual(const RoadPlaneWarp& warp, const NumberImage& before, const NumberImage& now,
                           const std::vector<RoadPlaneWarp::Node>& corners);

/// What is known of the motion beforehand, and where the search for it starts.
struct MotionGuess {
  Gaussian<PlaneMotion::kSize> prior;
  PlaneMotion start;
};

/// The most probable motion given what is known beforehand, by Gauss-Newton on the textures' differences,
/// cells that do not fit counting little. The covariance allows for pixels whose errors are alike.
RoadPlaneAlignment align_road_plane(const RoadPair& pair, const CameraPose& pose, const MotionGuess& guess);

}  // namespace lanefuse
