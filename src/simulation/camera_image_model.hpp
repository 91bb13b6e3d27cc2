// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/random.hpp"
#include "simulation/camera_body.hpp"
#include "simulation/camera_renderer.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// The lenses and chips of the rendered cameras: 1176 x 640 over 53 deg, and 2560 x 900 over 48 deg.
CameraIntrinsics serial_camera_intrinsics();
CameraIntrinsics high_resolution_camera_intrinsics();

/// A camera that hands over images: the serial or the high-resolution one, instead of the models that hand
/// over what such a camera would have found in them. Same names, rates and latencies. It stands a little
/// otherwise than the rig says: by a mounting error that is drawn once a drive, by the preset's yaw bias, and
/// by the body's motion, which it shares with the other camera.
class CameraImageModel final : public SensorModel {
 public:
  struct Setup {
    SensorDescription sensor;  ///< with its nominal mounting and intrinsics
    double hz = 0;
    double latency = 0;  ///< [s]
  };

  CameraImageModel(const Setup& setup, const CameraPosePreset& pose, std::shared_ptr<BodyMotion> body,
                   const RenderConfig& render);

  [[nodiscard]] SensorDescription description() const override { return setup_.sensor; }
  [[nodiscard]] double hz() const override { return setup_.hz; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

  /// How the camera stood over the road in the last image: for tests and evaluation.
  [[nodiscard]] const Mounting& true_mounting_of_last() const { return last_; }

 private:
  Setup setup_;
  std::shared_ptr<BodyMotion> body_;
  CameraRenderer renderer_;
  Random random_;
  MountingError error_;
  Wander yaw_bias_;
  Mounting last_;
};

CameraImageModel::Setup serial_camera_setup(const SensorPreset& preset);
CameraImageModel::Setup high_resolution_camera_setup(const SensorPreset& preset);

}  // namespace lanefuse
