// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_boxes_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "camera/ground_projection.hpp"
#include "simulation/line_of_sight.hpp"

namespace lanefuse {
namespace {

constexpr double kMostHidden = 0.5;   ///< share of its width, of a vehicle that gets a box
constexpr double kLeastInside = 0.5;  ///< share of a box that lies in the image
constexpr double kNearestFalse = 10;  ///< [m] at which a box of nothing seems to stand
constexpr double kConfidenceSpread = 0.1;

/// As place_of_vehicle, where there may be no road.
VehiclePlace place_in(const Scene& scene, const SceneVehicle& vehicle) {
  if (scene.road) return place_of_vehicle(vehicle, scene);
  const Pose2 world_from_rear = vehicle.world_from_vehicle * Pose2{-vehicle.rear, 0, 0};
  return {scene.ego.world_from_vehicle.inverse() * world_from_rear, 0};
}

bool is_framed(const BoxDetection& box, const CameraIntrinsics& camera) {
  const double inside = std::min(box.right, camera.width - 0.5) - std::max(box.left, -0.5);
  return inside >= kLeastInside * (box.right - box.left) && box.bottom < camera.height - 0.5 &&
         box.bottom > -0.5;
}

void cut_off(BoxDetection& box, const CameraIntrinsics& camera) {
  box.left = std::clamp(box.left, -0.5, camera.width - 0.5);
  box.right = std::clamp(box.right, -0.5, camera.width - 0.5);
  box.top = std::clamp(box.top, -0.5, camera.height - 0.5);
  box.bottom = std::clamp(box.bottom, -0.5, camera.height - 0.5);
}

}  // namespace

CameraIntrinsics object_camera_intrinsics(const SensorPreset& preset) {
  CameraIntrinsics camera;
  camera.width = 1176;
  camera.height = 640;
  camera.fx = camera.fy = 1 / preset.serial_camera.pixel;
  camera.cx = (camera.width - 1) / 2.0;
  camera.cy = 290;  // the horizon lies above the middle: there is more to see of the road than of the sky
  return camera;
}

std::optional<BoxDetection> box_of(const VehicleBody& body, const VehiclePlace& place,
                                   const CameraModel& camera, const Mounting& mounting) {
  const GroundProjection projection(camera, {mounting});
  constexpr double kNone = std::numeric_limits<double>::infinity();
  BoxDetection box{kNone, kNone, -kNone, -kNone};
  for (const double x : {0.0, body.length}) {
    for (const double y : {-body.width / 2, body.width / 2}) {
      const Eigen::Vector2d corner = place.ego_from_vehicle * Eigen::Vector2d(x, y);
      const auto foot = projection.pixel(corner, place.ground);
      const auto head = projection.pixel(corner, place.ground + body.height);
      if (!foot || !head) return {};
      box.left = std::min({box.left, foot->x(), head->x()});
      box.right = std::max({box.right, foot->x(), head->x()});
      box.top = std::min(box.top, head->y());
      box.bottom = std::max(box.bottom, foot->y());
    }
  }
  return box;
}

CameraBoxesModel::CameraBoxesModel(const SensorPreset& preset, std::uint64_t seed)
    : preset_(preset.camera_boxes),
      pose_(preset.camera_pose),
      camera_(object_camera_intrinsics(preset)),
      random_(seed, "object camera"),
      pitch_(pose_.residual_pitch, pose_.residual_pitch_tau, random_),
      yaw_(pose_.yaw_bias, pose_.yaw_bias_tau, random_) {}

SensorDescription CameraBoxesModel::description() const {
  return {
      11, SensorKind::object_camera, "object camera", {0, 0, pose_.height, 0, 0, 0}, camera_.intrinsics()};
}

double CameraBoxesModel::detection(double distance) const {
  const double fraction = std::min(1.0, distance / 90);
  return preset_.detection_near + fraction * (preset_.detection_at_90_m - preset_.detection_near);
}

/// What a detector makes of a box that is there; nothing where none of it can be.
std::optional<BoxDetection> CameraBoxesModel::see(const BoxDetection& exact, double distance) {
  BoxDetection box = exact;
  box.left += random_.normal(preset_.sigma_edge_px);
  box.right += random_.normal(preset_.sigma_edge_px);
  box.top += random_.normal(preset_.sigma_edge_px);
  box.bottom += random_.normal(preset_.sigma_base_px);
  box.confidence = std::clamp(detection(distance) + random_.normal(kConfidenceSpread), 0.05, 1.0);
  if (!is_framed(exact, camera_.intrinsics())) return {};
  cut_off(box, camera_.intrinsics());
  if (!is_plausible(box)) return {};
  return box;
}

/// As large as a vehicle would be in that row.
void CameraBoxesModel::add_false_boxes(double reach, std::vector<BoxDetection>& boxes) {
  for (int left = random_.poisson(preset_.false_boxes); left > 0; --left) {
    const double distance = random_.uniform(kNearestFalse, preset_.range);
    const double half = (camera_.intrinsics().width - 1) / 2.0 / camera_.intrinsics().fx;
    const Pose2 place{distance, distance * random_.uniform(-half, half), 0};
    const VehicleBody body{false, 0.1, random_.uniform(1.6, 2.6), random_.uniform(1.3, 2.2)};
    const auto exact = box_of(body, {place, 0}, camera_, last_);
    const auto box = exact ? see(*exact, distance) : std::nullopt;
    if (box && distance < reach) boxes.push_back(*box);
  }
}

void CameraBoxesModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  pitch_.advance(1 / preset_.hz, random_);
  yaw_.advance(1 / preset_.hz, random_);
  last_ = description().mounting;
  last_.pitch += pitch_.value();
  last_.yaw += yaw_.value();
  const LineOfSight sight(scene);
  const double reach = std::min(preset_.range, scene.visibility);
  CameraBoxes message{stamp(description(), scene.time, preset_.latency), {}};
  for (const SceneVehicle& vehicle : scene.vehicles) {
    const VehiclePlace place = place_in(scene, vehicle);
    const double distance = place.ego_from_vehicle.position().norm();
    const auto exact = box_of(body_of(vehicle), place, camera_, last_);
    if (!exact || distance > reach || sight.hidden_share(vehicle.id) > kMostHidden) continue;
    if (!random_.chance(detection(distance))) continue;
    if (const auto box = see(*exact, distance)) message.boxes.push_back(*box);
  }
  add_false_boxes(reach, message.boxes);
  // From left to right: their order must not tell what is what.
  std::ranges::stable_sort(message.boxes, {}, &BoxDetection::left);
  measurements.emplace_back(std::move(message));
}

}  // namespace lanefuse
