// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "camera/image.hpp"

namespace lanefuse {

/// The ego lane's two markings on a straight road, as one image shows them: for calibrating a camera whose
/// mounting is not known yet. Everything is in directions of the CameraModel, (right, down) over depth.
struct StraightRoadView {
  Eigen::Vector2d vanishing = Eigen::Vector2d::Zero();  ///< where both markings meet
  std::vector<Eigen::Vector2d> left;                    ///< middles of the paint, from row to row
  std::vector<Eigen::Vector2d> right;
  double left_slope = 0;  ///< of the marking in the image: d right / d down
  double right_slope = 0;
};

struct StraightRoadConfig {
  double largest_angle = 0.17;    ///< [rad] between the camera's axis and the road, up, down and sideways
  double nearest_horizon = 0.03;  ///< of a point under the horizon, down over depth: 40 m for a car's camera
  int contrast = 12;              ///< of paint to the road beside it, in levels of 255
  int fewest_rows = 20;           ///< in which a marking must be seen
};

/// Finds bright bars row by row, the point that most of their lines run to, and of those lines the nearest on
/// either side. Nothing where there are no two.
std::optional<StraightRoadView> find_straight_road(const ImageView& image, const CameraModel& camera,
                                                   const StraightRoadConfig& config = {});

}  // namespace lanefuse
