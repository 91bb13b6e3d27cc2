// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "camera/image.hpp"
#include "sensors/camera_intrinsics.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

struct RoadPlaneMotionConfig {
  double nearest = 5.5;           ///< [m] ahead: the patch of road that is followed
  double farthest = 28;           ///< [m]
  double half_width = 6;          ///< [m] to either side
  double fastest = 60;            ///< [m/s] that the first search looks for
  double acceleration = 0.7;      ///< [m/s^2] that the acceleration changes by within a second, one sigma
  double yaw_acceleration = 0.1;  ///< [rad/s^2]
  double pitch_step_deg = 0.15;   ///< [deg] one sigma between two images
};

/// How the car moved between the last image and this one.
struct RoadPlaneMotionEstimate {
  double speed = 0;               ///< [m/s] filtered
  double yaw_rate = 0;            ///< [rad/s] filtered
  double speed_sigma = 0;         ///< [m/s] of the frame's noise; the scale's error comes on top
  double yaw_rate_sigma = 0;      ///< [rad/s]
  double pitch_change = 0;        ///< [rad] since the last image, positive: the nose went down
  double pitch_change_sigma = 0;  ///< [rad]
  double quality = 0;     ///< in [0, 1]: the share of the road's texture that moved as the estimate says
  bool measured = false;  ///< false: this image gave nothing and the filter alone went on
};

/// Speed, yaw rate and pitch change from the texture of the road plane alone (visual odometry for cars
/// without any other; direct alignment of the road's patch with warp prediction). What does not move in the
/// image (bonnet, reflections in the windscreen) and vehicles are left out. Speed is in units of the camera's
/// height: a height that is 3 % wrong makes it 3 % wrong.
class RoadPlaneMotion {
 public:
  explicit RoadPlaneMotion(const CameraIntrinsics& intrinsics, const RoadPlaneMotionConfig& config = {});
  ~RoadPlaneMotion();
  RoadPlaneMotion(RoadPlaneMotion&&) noexcept;
  RoadPlaneMotion& operator=(RoadPlaneMotion&&) noexcept;

  struct Input {
    ImageView image;         ///< of the camera's size
    const CameraPose& pose;  ///< the same for all images: the mounting, not this image's pitch
    double seconds = 0;      ///< since the last image, > 0; the first image's is ignored
    const std::vector<VehicleBox>& vehicles;  ///< in this image, left out
  };

  const RoadPlaneMotionEstimate& update(const Input& input);

  /// Forgets all motion: after a gap.
  void reset();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lanefuse
