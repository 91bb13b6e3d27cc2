// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/object_source.hpp"

#include <algorithm>
#include <iterator>

namespace lanefuse {
namespace {

/// How far the dead reckoning may be stretched to a scan's stamp.
constexpr Duration kReach = std::chrono::milliseconds(100);

/// Where the radar was, and how fast it moved over ground with the car's turning: v + omega x lever arm.
RadarTracker::Viewpoint viewpoint(const Mounting& mounting, const Pose2& odometry_from_vehicle,
                                  const MotionSample& motion) {
  const Pose2 vehicle_from_radar{mounting.x, mounting.y, mounting.yaw};
  const Eigen::Vector2d velocity(motion.speed - motion.yaw_rate * mounting.y, motion.yaw_rate * mounting.x);
  return {odometry_from_vehicle * vehicle_from_radar, rotation(odometry_from_vehicle.heading) * velocity};
}

}  // namespace

InputAccounting ObjectSource::add(const Measurement& measurement, const SourceContext& context) {
  if (const auto* list = std::get_if<ObjectList>(&measurement)) return add_list(*list, context);
  if (const auto* scan = std::get_if<RadarScan>(&measurement)) return add_scan(*scan, context);
  return {};
}

InputAccounting ObjectSource::add_list(const ObjectList& list, const SourceContext& context) {
  std::vector<TrackedObject> good;
  std::copy_if(list.objects.begin(), list.objects.end(), std::back_inserter(good),
               [](const TrackedObject& object) { return is_plausible(object); });
  bear_witness(good, list.stamp, context);
  objects_ = good;
  return {good.size(), list.objects.size() - good.size(), 0};
}

InputAccounting ObjectSource::add_scan(const RadarScan& scan, const SourceContext& context) {
  RadarScan good{scan.stamp, {}};
  std::copy_if(scan.detections.begin(), scan.detections.end(), std::back_inserter(good.detections),
               [](const RadarDetection& detection) { return is_plausible(detection); });
  InputAccounting accounting{0, scan.detections.size() - good.detections.size(), 0};
  const SensorDescription* radar = context.rig.find(scan.stamp.sensor_id);
  Pose2 odometry_from_vehicle;
  const bool moved = !context.motion.empty() &&
                     pose_at(context.motion, scan.stamp.measured_at, kReach, odometry_from_vehicle);
  if (!radar || !moved ||
      !tracker_.update(good, viewpoint(radar->mounting, odometry_from_vehicle, context.motion.back()))) {
    accounting.dropped = good.detections.size();
    return accounting;
  }
  accounting.used = good.detections.size();
  objects_ = tracker_.tracks(odometry_from_vehicle);
  bear_witness(objects_, scan.stamp, context);
  return accounting;
}

void ObjectSource::bear_witness(const std::vector<TrackedObject>& objects, const Stamp& stamp,
                                const SourceContext& context) {
  FeatureSet set;
  set.source = Source::objects;
  set.sensor_id = stamp.sensor_id;
  set.measured_at = stamp.measured_at;
  set.lane_width = context.lane_width.value_or(config_.witness.default_width);
  for (const TrackedObject& object : objects) {
    if (is_witness(object, config_.witness)) {
      add_witness_features(object, *set.lane_width, config_.witness, set.features);
    }
  }
  pending_.push_back(std::move(set));
}

void ObjectSource::collect(Time, const SourceContext&, std::vector<FeatureSet>& sets) {
  std::move(pending_.begin(), pending_.end(), std::back_inserter(sets));
  pending_.clear();
}

void ObjectSource::reset() {
  tracker_.reset();
  objects_.clear();
  pending_.clear();
}

}  // namespace lanefuse
