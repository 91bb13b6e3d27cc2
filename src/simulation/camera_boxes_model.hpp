// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "camera/camera_model.hpp"
#include "core/random.hpp"
#include "sensors/camera_view.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"
#include "simulation/vehicle_faces.hpp"

namespace lanefuse {

/// A camera that hands over boxes of the vehicles ahead, as a detector finds them in its images: around the
/// whole vehicle, so that a side that is seen belongs to the box; cut off at the image's border. The farther
/// away, the more are missed; now and then there is a box of nothing. Of a vehicle that is hidden by half
/// there is none. It stands where the serial camera does, and in each image a little otherwise than that
/// says: by what is left of the body's pitching, and by the calibration's yaw.
class CameraBoxesModel final : public SensorModel {
 public:
  CameraBoxesModel(const SensorPreset& preset, std::uint64_t seed);
  [[nodiscard]] SensorDescription description() const override;
  [[nodiscard]] double hz() const override { return preset_.hz; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

  /// How the camera stood over the road in the last image: for tests.
  [[nodiscard]] const Mounting& true_mounting_of_last() const { return last_; }

 private:
  CameraBoxesPreset preset_;
  CameraPosePreset pose_;
  CameraModel camera_;
  Random random_;
  Wander pitch_;  ///< [rad]
  Wander yaw_;    ///< [rad]
  Mounting last_;

  [[nodiscard]] double detection(double distance) const;
  std::optional<BoxDetection> see(const BoxDetection& exact, double distance);
  void add_false_boxes(double reach, std::vector<BoxDetection>& boxes);
};

/// The lens and chip of the object camera: the preset's pixels of the serial camera, no distortion.
CameraIntrinsics object_camera_intrinsics(const SensorPreset& preset);

/// The box around a vehicle as the camera that stands so images it: [px], beyond the image, too; nothing
/// where a part of the vehicle is not ahead of the camera.
std::optional<BoxDetection> box_of(const VehicleBody& body, const VehiclePlace& place,
                                   const CameraModel& camera, const Mounting& mounting);

}  // namespace lanefuse
