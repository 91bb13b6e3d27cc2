// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "camera/image.hpp"
#include "sensors/camera_intrinsics.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

struct VehicleDetectorConfig {
  double nearest = 5;         ///< [m] along x to the rear of a vehicle
  double farthest = 55;       ///< [m]
  double widest_view = 11;    ///< [m] to either side; what stands further off is beside the road
  double narrowest = 1.3;     ///< [m] a vehicle
  double widest = 2.7;        ///< [m]
  int frames_to_confirm = 3;  ///< a box must have been seen in so many images before it is reported
  double coast = 0.4;         ///< [s] for which a box is kept without being seen
};

/// Finds vehicles in images without any learned weights: by what breaks the motion of the road plane between
/// two images, by the dark line under a car and by upright edges on both sides, of a width that fits the
/// range that the ground projection gives; followed over images by a small filter. Good enough to keep
/// marking features off other cars and to verify radar tracks; it is no safety function.
class VehicleDetector {
 public:
  explicit VehicleDetector(const CameraIntrinsics& intrinsics, const VehicleDetectorConfig& config = {});
  ~VehicleDetector();
  VehicleDetector(VehicleDetector&&) noexcept;
  VehicleDetector& operator=(VehicleDetector&&) noexcept;

  struct Input {
    ImageView image;         ///< of the camera's size
    const CameraPose& pose;  ///< the best guess for this image
    double speed = 0;        ///< [m/s] of the own car
    double yaw_rate = 0;     ///< [rad/s]
    double seconds = 0;      ///< since the last image; the first image's is ignored
  };

  /// The vehicles in this image, the nearest first; the same until the next call.
  const std::vector<VehicleBox>& detect(const Input& input);

  /// Forgets what it saw: after a gap, or where the camera has moved.
  void reset();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lanefuse
