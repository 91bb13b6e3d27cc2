// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_image_model.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "camera/image_codec.hpp"

namespace lanefuse {
namespace {

constexpr int kJpegQuality = 92;

/// `field` [rad] across the image without distortion; `horizon`: row of the principal point, which lies
/// higher than the middle, as more is to be seen of the road than of the sky.
CameraIntrinsics intrinsics(int width, int height, double field, double horizon) {
  CameraIntrinsics camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = width / 2.0 / std::tan(field / 2);
  camera.cx = (width - 1) / 2.0;
  camera.cy = horizon;
  camera.distortion = {-0.05, 0, 0, 0, 0};
  return camera;
}

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

CameraIntrinsics serial_camera_intrinsics() { return intrinsics(1176, 640, 53 * kDegree, 290); }

CameraIntrinsics high_resolution_camera_intrinsics() { return intrinsics(2560, 900, 48 * kDegree, 350); }

CameraImageModel::Setup serial_camera_setup(const SensorPreset& preset) {
  return {{2,
           SensorKind::serial_camera,
           "serial camera",
           {0, 0, preset.camera_pose.height, 0, 0, 0},
           serial_camera_intrinsics()},
          preset.serial_camera.hz,
          preset.serial_camera.latency};
}

CameraImageModel::Setup high_resolution_camera_setup(const SensorPreset& preset) {
  return {{3,
           SensorKind::high_resolution_camera,
           "high-resolution camera",
           {0, 0, preset.camera_pose.height, 0, 0, 0},
           high_resolution_camera_intrinsics()},
          preset.high_resolution_camera.hz,
          preset.high_resolution_camera.latency};
}

CameraImageModel::CameraImageModel(const Setup& setup, const CameraPosePreset& pose,
                                   std::shared_ptr<BodyMotion> body, const RenderConfig& render)
    : setup_(setup),
      body_(std::move(body)),
      renderer_(setup.sensor.camera.value(), render),
      random_(render.seed, setup.sensor.name + " mounting"),
      error_(draw_mounting_error(random_)),
      yaw_bias_(pose.yaw_bias, pose.yaw_bias_tau, random_) {}

void CameraImageModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  yaw_bias_.advance(1 / setup_.hz, random_);
  last_ = true_mounting(setup_.sensor.mounting, error_, body_->at(scene.time));
  last_.yaw += yaw_bias_.value();
  const Image image = renderer_.render(scene, last_);
  CameraImage message{stamp(setup_.sensor, scene.time, setup_.latency), "jpeg", {}};
  message.bytes = encode_jpeg(image.view(), kJpegQuality);
  measurements.emplace_back(std::move(message));
}

}  // namespace lanefuse
