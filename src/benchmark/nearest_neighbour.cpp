// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/nearest_neighbour.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

/// How far the dead reckoning may be stretched.
constexpr Duration kReach = std::chrono::milliseconds(100);

}  // namespace

void NearestNeighbour::add(const Measurement& measurement, std::span<const MotionSample> motion) {
  const auto* scan = std::get_if<RadarScan>(&measurement);
  const SensorDescription* radar = scan ? rig_.find(scan->stamp.sensor_id) : nullptr;
  Pose2 odometry_from_vehicle;
  if (!radar || motion.empty() || !pose_at(motion, scan->stamp.measured_at, kReach, odometry_from_vehicle)) {
    return;
  }
  RadarScan good{scan->stamp, scan->detections};
  std::erase_if(good.detections, [](const RadarDetection& one) { return !is_plausible(one); });
  const Mounting& mounting = radar->mounting;
  const MotionSample& own = motion.back();
  const Eigen::Vector2d velocity(own.speed - own.yaw_rate * mounting.y, own.yaw_rate * mounting.x);
  const RadarTracker::Viewpoint viewpoint{odometry_from_vehicle * Pose2{mounting.x, mounting.y, mounting.yaw},
                                          rotation(odometry_from_vehicle.heading) * velocity};
  if (tracker_.update(good, viewpoint)) last_scan_ = good.stamp.measured_at;
}

std::vector<TrackedObject> NearestNeighbour::objects(Time now, std::span<const MotionSample> motion) const {
  Pose2 odometry_from_vehicle;
  if (!last_scan_ || motion.empty() || !pose_at(motion, now, kReach, odometry_from_vehicle)) return {};
  // The odometry frame does not move: seen from where the car is now, the tracks are where they were then.
  std::vector<TrackedObject> objects = tracker_.tracks(odometry_from_vehicle);
  std::erase_if(objects, [](const TrackedObject& one) { return one.movement != MovementState::moving; });
  const double seconds = to_seconds(now - *last_scan_);
  for (TrackedObject& object : objects) {
    object.x += seconds * object.speed * std::cos(object.heading);
    object.y += seconds * object.speed * std::sin(object.heading);
    object.witness = is_witness(object, witness_);
  }
  return objects;
}

}  // namespace lanefuse
