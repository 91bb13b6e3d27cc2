// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "camera/straight_road.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// What is known beside the images. Sigmas are one standard deviation; per image, unless they say otherwise.
struct MountingCalibrationConfig {
  double lane_width = 3.66;        ///< [m] between the middles of the ego lane's markings
  double lane_width_sigma = 0.05;  ///< [m]
  double offset_sigma = 0.3;       ///< [m] of the car about the middle of its lane
  double heading_sigma_deg = 0.3;  ///< [deg] of the car to the lane
  double pitch_sigma_deg = 0.2;    ///< [deg] of the car on its springs and of the road ahead
  double roll_sigma_deg = 1;       ///< [deg] of the camera, once: hung upright as well as one can see
  double point_sigma_px = 1.5;     ///< [px] of the paint's middle, with what is left of the lens's error
  double outlier_width = 0.06;  ///< share by which an image's lane may be wider or narrower than the others'
  double outlier_deg = 1.5;     ///< [deg] by which an image's vanishing point may differ from the others'
};

struct MountingCalibration {
  Mounting mounting;  ///< x and y as they were handed in
  /// Covariance of (height [m], roll, pitch, yaw [rad]).
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  int views_used = 0;
  struct ViewFit {
    bool used = false;  ///< false: its road looks unlike the others', on a bend or while changing lanes
    double rms_px = 0;  ///< of the paint's middles across the lines, at the image
    double offset = 0;  ///< [m] of the car from the middle of its lane, positive to the left
  };
  std::vector<ViewFit> views;  ///< as they were handed in
};

/// How the camera stands, from straight roads of a known lane width: the vanishing point gives pitch and yaw,
/// the width between the markings the height; of the roll, hardly more than what was assumed is learned.
/// Least squares over all images together, with the priors of the config. `start` gives x and y.
///
/// Throws an input Error where there is no view, or no two of several agree.
MountingCalibration calibrate_mounting(std::span<const StraightRoadView> views, const CameraModel& camera,
                                       const Mounting& start, const MountingCalibrationConfig& config = {});

}  // namespace lanefuse
