// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "core/pose2.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "sensors/truth.hpp"

/// What radars and a camera that boxes vehicles say of the traffic of true frames: written down apart from
/// the simulator's sensors and from what tracks, so that both can be held against it.
namespace lanefuse::testing {

inline constexpr std::uint32_t kFrontRadar = 101;
inline constexpr std::uint32_t kBoxCamera = 102;
inline constexpr std::uint32_t kLeftRadar = 103;
inline constexpr std::uint32_t kRightRadar = 104;
inline constexpr double kHeight = 1.5;  ///< [m] of every vehicle

inline std::vector<SensorDescription> object_sensors() {
  CameraIntrinsics lens{1280, 960, 1400, 1400, 639.5, 479.5, {}};
  return {{kFrontRadar, SensorKind::long_range_radar, "front radar", {0.8, 0, 0.5}},
          {kBoxCamera, SensorKind::object_camera, "box camera", {-1.2, 0, 1.25}, lens},
          {kLeftRadar, SensorKind::short_range_radar, "left radar", {0.6, 0.8, 0.5, 0, 0, 0.8}},
          {kRightRadar, SensorKind::short_range_radar, "right radar", {0.6, -0.8, 0.5, 0, 0, -0.8}}};
}

/// The sensors, each with noise of its own, and posts along the way of the car that stand.
class DetectedTraffic {
 public:
  explicit DetectedTraffic(double noise = 0, bool posts = false, unsigned seed = 1)
      : noise_(noise), posts_(posts), random_(seed) {}

  RadarScan scan(std::uint32_t sensor, const TrueFrame& frame) {
    RadarScan scan{{frame.time, frame.time, sensor}, {}};
    for (const TrueObject& object : frame.objects) {
      if (const auto seen = reflection(sensor, frame, nearest_point(sensor, frame, object), velocity(object)))
        scan.detections.push_back(*seen);
    }
    for (const Eigen::Vector2d& post : posts(frame)) {
      if (const auto seen = reflection(sensor, frame, post, {0, 0})) scan.detections.push_back(*seen);
    }
    return scan;
  }

  CameraBoxes boxes(const TrueFrame& frame) {
    CameraBoxes boxes{{frame.time, frame.time, kBoxCamera}, {}};
    for (const TrueObject& object : frame.objects) {
      if (const auto box = box_of(frame, object)) boxes.boxes.push_back(*box);
    }
    return boxes;
  }

  /// Looks of all sensors, in one moment.
  std::vector<Measurement> looks(const TrueFrame& frame) {
    std::vector<Measurement> all;
    for (const std::uint32_t radar : {kFrontRadar, kLeftRadar, kRightRadar})
      all.emplace_back(scan(radar, frame));
    all.emplace_back(boxes(frame));
    return all;
  }

 private:
  double noise_;
  bool posts_;
  std::mt19937 random_;
  std::optional<Pose2> last_;
  double way_ = 0;        ///< [m] driven
  double next_post_ = 0;  ///< [m] on the way
  std::vector<Eigen::Vector2d> standing_;

  static const SensorDescription& sensor_of(std::uint32_t id) {
    static const auto sensors = object_sensors();
    return *std::ranges::find(sensors, id, &SensorDescription::id);
  }
  static Eigen::Vector2d velocity(const TrueObject& object) {
    return object.speed * Eigen::Vector2d(std::cos(object.world_from_object.heading),
                                          std::sin(object.world_from_object.heading));
  }
  static Pose2 pose_of(std::uint32_t sensor, const TrueFrame& frame) {
    const Mounting& at = sensor_of(sensor).mounting;
    return frame.world_from_vehicle * Pose2{at.x, at.y, at.yaw};
  }
  /// The sum of twelve even numbers is near enough to a normal one, on every machine the same.
  double normal(double sigma) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random_()) / 4294967296.0;
    return sum * sigma * noise_;
  }

  /// On the vehicle's long axis: its rear from behind, its front from ahead.
  static Eigen::Vector2d nearest_point(std::uint32_t sensor, const TrueFrame& frame,
                                       const TrueObject& object) {
    const Eigen::Vector2d at = object.world_from_object.inverse() * pose_of(sensor, frame).position();
    return object.world_from_object * Eigen::Vector2d(std::clamp(at.x(), 0.0, object.length), 0);
  }

  std::optional<RadarDetection> reflection(std::uint32_t sensor, const TrueFrame& frame,
                                           const Eigen::Vector2d& point, const Eigen::Vector2d& velocity) {
    const bool front = sensor == kFrontRadar;
    const Pose2 pose = pose_of(sensor, frame);
    const Eigen::Vector2d in_radar = pose.inverse() * point;
    const double range = in_radar.norm();
    const double bearing = std::atan2(in_radar.y(), in_radar.x());
    const double half = front ? (range < 60 ? 0.48 : 0.14) : 1.3;
    if (range > (front ? 200 : 50) || range < 1 || std::abs(bearing) > half) return {};
    const Mounting& mounting = sensor_of(sensor).mounting;
    const Eigen::Vector2d own(frame.speed - frame.yaw_rate * mounting.y, frame.yaw_rate * mounting.x);
    const Eigen::Vector2d sight = (point - pose.position()).normalized();
    const double rate = sight.dot(velocity - rotation(frame.world_from_vehicle.heading) * own);
    return RadarDetection{range + normal(0.2), bearing + normal(front ? 0.003 : 0.02), rate + normal(0.1)};
  }

  /// Two rows of posts, 12 m and 11 m beside where the car drives to when they come into sight.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& posts(const TrueFrame& frame) {
    constexpr double kApart = 25;
    constexpr double kSight = 100;  // [m]
    if (!posts_) return standing_;
    if (last_) way_ += (frame.world_from_vehicle.position() - last_->position()).norm();
    last_ = frame.world_from_vehicle;
    for (; next_post_ < way_ + kSight; next_post_ += kApart) {
      for (const double y : {12.0, -11.0})
        standing_.push_back(frame.world_from_vehicle * Eigen::Vector2d(next_post_ - way_, y));
    }
    std::erase_if(standing_, [&](const Eigen::Vector2d& post) {
      return (frame.world_from_vehicle.inverse() * post).x() < -kSight;
    });
    return standing_;
  }

  std::optional<BoxDetection> box_of(const TrueFrame& frame, const TrueObject& object) {
    const SensorDescription& camera = sensor_of(kBoxCamera);
    const CameraIntrinsics& lens = *camera.camera;
    const Pose2 camera_from_world = pose_of(kBoxCamera, frame).inverse();
    constexpr double kFar = std::numeric_limits<double>::max();
    BoxDetection box{kFar, kFar, -kFar, -kFar};
    for (const double along : {0.0, object.length}) {
      for (const double across : {-object.width / 2, object.width / 2}) {
        const Eigen::Vector2d at =
            camera_from_world * (object.world_from_object * Eigen::Vector2d(along, across));
        if (at.x() < 3 || at.x() > 95) return {};
        for (const double up : {0.0, kHeight}) {
          const double u = lens.cx - lens.fx * at.y() / at.x();
          const double v = lens.cy + lens.fy * (camera.mounting.z - up) / at.x();
          box = {std::min(box.left, u), std::min(box.top, v), std::max(box.right, u),
                 std::max(box.bottom, v)};
        }
      }
    }
    for (double* edge : {&box.left, &box.top, &box.right, &box.bottom}) *edge += normal(1.2);
    const double middle = (box.left + box.right) / 2;
    if (middle < 0 || middle > lens.width) return {};
    return box;
  }
};

}  // namespace lanefuse::testing
