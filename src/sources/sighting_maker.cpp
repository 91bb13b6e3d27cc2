// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/sighting_maker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "camera/ground_projection.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// How far the dead reckoning may be stretched to a stamp.
constexpr Duration kReach = std::chrono::milliseconds(100);

/// Where the sensor was, and how fast it moved over ground with the car's turning: v + omega x lever arm.
bool place(const Stamp& stamp, const SensorDescription& sensor, const SourceContext& context,
           SightingSet& look) {
  Pose2 odometry_from_vehicle;
  if (context.motion.empty() || !pose_at(context.motion, stamp.measured_at, kReach, odometry_from_vehicle)) {
    return false;
  }
  const Mounting& mounting = sensor.mounting;
  const MotionSample& motion = context.motion.back();
  const Eigen::Vector2d velocity(motion.speed - motion.yaw_rate * mounting.y, motion.yaw_rate * mounting.x);
  constexpr double kSlowest = 5;  // [m/s] below which a yaw rate says little of the road
  look.measured_at = stamp.measured_at;
  look.sensor_id = stamp.sensor_id;
  look.odometry_from_vehicle = odometry_from_vehicle;
  look.odometry_from_sensor = odometry_from_vehicle * Pose2{mounting.x, mounting.y, mounting.yaw};
  look.velocity = rotation(odometry_from_vehicle.heading) * velocity;
  look.own_curvature = motion.speed > kSlowest ? motion.yaw_rate / motion.speed : 0;
  look.sightings.clear();
  return true;
}

SensorField field_of(const RadarConfig& radar) {
  return {.range = radar.range,
          .half_angle = radar.field_deg / 2 * kDegree,
          .near_range = radar.near_range,
          .near_half_angle = radar.near_field_deg / 2 * kDegree,
          .detection = radar.detection,
          .detection_far = radar.detection};
}

/// An image's edge cuts the box, where it lies this near to it.
constexpr double kEdge = 3;  ///< [px]

struct Weighed {
  double sum = 0;
  double weight = 0;
  void add(double value, double sigma) {
    sum += value / (sigma * sigma);
    weight += 1 / (sigma * sigma);
  }
};

}  // namespace

bool SightingMaker::make(const RadarScan& scan, const SourceContext& context, SightingSet& look) const {
  const SensorDescription* sensor = context.rig.find(scan.stamp.sensor_id);
  if (!sensor || !place(scan.stamp, *sensor, context, look)) return false;
  const bool short_range = sensor->kind == SensorKind::short_range_radar;
  if (!short_range && sensor->kind != SensorKind::long_range_radar) return false;
  const RadarConfig& radar = short_range ? config_.short_range_radar : config_.long_range_radar;
  look.kind = SightingKind::radar;
  look.field = field_of(radar);
  for (const RadarDetection& detection : scan.detections) {
    if (!is_plausible(detection)) continue;
    Sighting& sighting = look.sightings.emplace_back();
    sighting.range = detection.range;
    sighting.bearing = detection.bearing;
    sighting.range_sigma = radar.sigma_range;
    sighting.bearing_sigma = radar.sigma_bearing_deg * kDegree;
    sighting.range_rate = detection.range_rate;
    sighting.range_rate_sigma = radar.sigma_range_rate;
    if (!detection.new_track) sighting.address = detection.address;
  }
  return true;
}

bool SightingMaker::make(const CameraBoxes& boxes, const SourceContext& context, SightingSet& look) {
  const SensorDescription* sensor = context.rig.find(boxes.stamp.sensor_id);
  if (!sensor || !sensor->camera || !place(boxes.stamp, *sensor, context, look)) return false;
  const ObjectCameraConfig& camera = config_.camera;
  look.kind = SightingKind::camera;
  // Boxes that were found in images by the way verify a vehicle; that there is none refutes nothing.
  const bool finds_all = sensor->kind == SensorKind::object_camera;
  look.field = {.range = camera.range,
                .half_angle = camera.field_deg / 2 * kDegree,
                .detection = finds_all ? camera.detection : 0,
                .detection_far = finds_all ? camera.detection_far : 0};
  const CameraModel& lens = lens_of(*sensor);
  for (const BoxDetection& box : boxes.boxes) {
    if (!is_plausible(box)) continue;
    if (const auto sighting = sighting_of(box, *sensor, lens)) look.sightings.push_back(*sighting);
  }
  return true;
}

const CameraModel& SightingMaker::lens_of(const SensorDescription& sensor) {
  const auto known = lenses_.find(sensor.id);
  return known != lenses_.end() ? known->second : lenses_.emplace(sensor.id, *sensor.camera).first->second;
}

/// The range by the base line and by the width, both as its inverse: that is what their errors are even in.
std::optional<Sighting> SightingMaker::sighting_of(const BoxDetection& box, const SensorDescription& sensor,
                                                   const CameraModel& lens) const {
  const ObjectCameraConfig& camera = config_.camera;
  const CameraIntrinsics& intrinsics = lens.intrinsics();
  const GroundProjection projection(lens, {.mounting = sensor.mounting});
  const auto bearing_at = [&](double column) { return -std::atan(lens.direction({column, box.bottom}).x()); };
  const double left = bearing_at(box.left);
  const double right = bearing_at(box.right);
  const bool cut = box.left < kEdge || box.right > intrinsics.width - kEdge;
  const bool base_seen = box.bottom < intrinsics.height - kEdge;
  // What is found in images by the way is boxed roughly.
  constexpr double kRough = 4;
  const double rough = sensor.kind == SensorKind::object_camera ? 1 : kRough;
  const double edge = rough * camera.sigma_edge_px / intrinsics.fx;

  Weighed inverse_range;
  const auto base = projection.ground({(box.left + box.right) / 2, box.bottom});
  const double height = std::max(0.1, sensor.mounting.z);
  const double base_sigma =
      std::hypot(rough * camera.sigma_base_px / intrinsics.fy, camera.sigma_pitch_deg * kDegree) / height;
  if (base && base_seen) {
    const Eigen::Vector2d apart = *base - Eigen::Vector2d(sensor.mounting.x, sensor.mounting.y);
    inverse_range.add(1 / std::max(1.0, apart.norm()), base_sigma);
  }
  if (!cut) {
    const double width = (left - right) / camera.vehicle_width;
    inverse_range.add(width,
                      std::hypot(width * camera.vehicle_width_sigma, 1.4 * edge) / camera.vehicle_width);
  }
  if (inverse_range.weight <= 0) return {};
  const double mean = inverse_range.sum / inverse_range.weight;
  constexpr double kFarthest = 300;  // [m]
  if (!(mean > 1 / kFarthest)) return {};
  Sighting sighting;
  sighting.range = 1 / mean;
  sighting.range_sigma = sighting.range * sighting.range / std::sqrt(inverse_range.weight);
  sighting.bearing = (left + right) / 2;
  sighting.bearing_sigma = std::hypot(edge / std::numbers::sqrt2, camera.sigma_yaw_deg * kDegree);
  if (cut) sighting.bearing_sigma += (left - right) / 2;
  if (!cut) sighting.angular_width = left - right;
  sighting.angular_width_sigma = std::numbers::sqrt2 * edge;
  sighting.confidence = box.confidence;
  return sighting;
}

}  // namespace lanefuse
