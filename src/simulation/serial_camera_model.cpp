// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/serial_camera_model.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kNearest = 5;       ///< [m] ahead of the origin; the bonnet hides what is nearer
constexpr double kLeastSpacing = 2;  ///< [m] between the rows that it looks at
constexpr double kField = 0.5;       ///< [rad] to either side: 1280 columns of .79 mrad
constexpr double kPatience = 1;      ///< [s] without a point of a marking until it is no longer reported

int line_of(const Road& road, int lane, Side side) {
  return side == Side::left ? road.left_line(lane) : road.right_line(lane);
}

/// Whether the car went into the next lane on the left (+1) or right (-1), or stayed (0): a lane that
/// continues another is the same to the camera.
int crossing(const Road& road, int from, int to, double station) {
  if (road.left_line(to) == road.right_line(from)) return -1;
  if (road.right_line(to) == road.left_line(from)) return +1;
  const double way = road.lane_centre(to, station) - road.lane_centre(from, station);
  if (std::abs(way) < road.lane_width(to, station) / 2) return 0;
  return way > 0 ? +1 : -1;
}

}  // namespace

SerialCameraModel::SerialCameraModel(const SensorPreset& preset, std::uint64_t seed)
    : preset_(preset.serial_camera),
      pose_(preset.camera_pose),
      random_(seed, "serial camera"),
      odometry_(preset.odometry, seed),
      view_(preset.camera_pose, random_),
      tracker_(preset_.noise_px * preset_.pixel / preset.noise) {}

SensorDescription SerialCameraModel::description() const {
  return {2, SensorKind::serial_camera, "serial camera", {0, 0, pose_.height, 0, 0, 0}};
}

/// Uniform between the preset's largest range and as far below its mean.
double SerialCameraModel::draw_range() {
  return random_.uniform(2 * preset_.range_mean - preset_.range_max, preset_.range_max);
}

/// Far away, where an image row covers more ground than that, every row is looked at.
double SerialCameraModel::spacing(double x) const {
  return std::max(kLeastSpacing, view_.row_footprint(x, preset_.pixel));
}

void SerialCameraModel::move_tracker(const Scene& scene) {
  std::vector<Measurement> heard;
  odometry_.observe(scene, heard);
  const auto& motion = std::get<VehicleMotion>(heard.front());
  tracker_.predict(1 / preset_.hz, *motion.speed, *motion.yaw_rate);
  const double station = scene.ego.station;
  const int lane = scene.road->lane_at(station, scene.ego.lateral).value_or(std::max(lane_, 0));
  if (lane_ >= 0 && lane != lane_) tracker_.cross(crossing(*scene.road, lane_, lane, station));
  lane_ = lane;
}

void SerialCameraModel::detect_edge(const Scene& scene, const LineOfSight& sight, Side side, double range,
                                    std::vector<SerialLaneTracker::Point>& points) {
  const Road& road = *scene.road;
  const int line = line_of(road, lane_, side);
  const Pose2 ego_from_world = scene.ego.world_from_vehicle.inverse();
  for (double x = kNearest; x < range; x += spacing(x)) {
    const double station = scene.ego.station + x;
    if (!road.painted(line, station)) continue;
    const double inwards = (side == Side::left ? -0.5 : 0.5) * road.marking_width(line, station);
    const Pose2 edge = ego_from_world * road.pose(station, road.line_lateral(line, station) + inwards);
    if (std::abs(std::atan2(edge.y, edge.x)) > kField || sight.blocked(edge.position())) continue;
    const double height = road.height().above_tangent(scene.ego.station, station);
    const double column = random_.normal(preset_.noise_px * preset_.pixel);
    const auto seen = view_.see(edge.position(), height, {0, column});
    if (seen) points.push_back({*seen, side});
  }
}

std::vector<SerialLaneTracker::Point> SerialCameraModel::detect(const Scene& scene, double range) {
  const LineOfSight sight(scene);
  std::vector<SerialLaneTracker::Point> points;
  detect_edge(scene, sight, Side::left, range, points);
  left_unseen_ = points.empty() ? left_unseen_ + 1 / preset_.hz : 0;
  const std::size_t left_points = points.size();
  detect_edge(scene, sight, Side::right, range, points);
  right_unseen_ = points.size() == left_points ? right_unseen_ + 1 / preset_.hz : 0;
  return points;
}

ClothoidMeasurement SerialCameraModel::hand_over(const Scene& scene, Side side, double range) const {
  ClothoidMeasurement measurement = tracker_.boundary(side);
  measurement.range_begin = 0;
  measurement.range_end = range;
  measurement.confidence = 1 - preset_.dropout;
  const int line = line_of(*scene.road, lane_, side);
  measurement.marking = scene.road->marking(line, scene.ego.station);
  measurement.label = scene.road->line_label(line);
  return measurement;
}

void SerialCameraModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  view_.advance(1 / preset_.hz, random_);
  move_tracker(scene);
  SerialLane lane;
  lane.stamp = stamp(description(), scene.time, preset_.latency);
  const double range = std::min(draw_range(), scene.visibility);
  const bool dropped = random_.chance(preset_.dropout);
  if (!dropped) tracker_.update(detect(scene, range));
  if (!dropped && tracker_.settled()) {
    if (left_unseen_ < kPatience) lane.left = hand_over(scene, Side::left, range);
    if (right_unseen_ < kPatience) lane.right = hand_over(scene, Side::right, range);
  }
  measurements.emplace_back(std::move(lane));
}

}  // namespace lanefuse
