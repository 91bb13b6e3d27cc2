// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/comma2k19.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "importing/array_log.hpp"
#include "importing/comma2k19_segment.hpp"
#include "importing/comma2k19_truth.hpp"

namespace lanefuse {
namespace {

/// The radar sends a scan's points one bus message each, within 11 ms, every 50 ms.
constexpr Duration kScanGap = from_seconds(0.015);

/// In the front grille, about 0.1 m behind the bumper of a RAV4, whose front overhang is 0.92 m. Its yaw
/// against the direction of travel is 0.002 +- 0.002 rad (docs/comma2k19.md): not different from none.
constexpr Mounting kRadarMounting{.x = 0.85, .y = 0, .z = 0.6, .roll = 0, .pitch = 0, .yaw = 0};

enum RadarColumn : std::size_t { kForward = 0, kLeft = 1, kRangeRate = 2, kAddress = 3, kNewTrack = 4 };

using Notes = std::vector<std::string>;

/// A log of the folder processed_log: `columns` in the file, of which `kept` are read.
ArrayLog read_log(const std::filesystem::path& folder, std::size_t columns, std::vector<std::size_t> kept,
                  Notes& notes) {
  return read_array_log({.times = folder / "t", .values = {{folder / "value", columns, std::move(kept)}}},
                        notes);
}

VehicleMotion motion_at(Time time) {
  return {.stamp = {time, time, kCommaOdometry}, .speed = {}, .yaw_rate = {}, .wheel_speeds = {}};
}

void add_speeds(const ArrayLog& log, std::vector<Measurement>& measurements) {
  for (std::size_t row = 0; row < log.times.size(); ++row) {
    VehicleMotion motion = motion_at(log.times[row]);
    motion.speed = log.values(row, 0);
    measurements.emplace_back(motion);
  }
}

void add_wheel_speeds(const ArrayLog& log, std::vector<Measurement>& measurements) {
  for (std::size_t row = 0; row < log.times.size(); ++row) {
    VehicleMotion motion = motion_at(log.times[row]);
    motion.wheel_speeds = {log.values(row, 0), log.values(row, 1), log.values(row, 2), log.values(row, 3)};
    measurements.emplace_back(motion);
  }
}

/// The gyro turns about (forward, right, down), so that its third rate counts clockwise turns.
void add_yaw_rates(const ArrayLog& log, std::vector<Measurement>& measurements) {
  for (std::size_t row = 0; row < log.times.size(); ++row) {
    VehicleMotion motion = motion_at(log.times[row]);
    motion.yaw_rate = -log.values(row, 0);
    measurements.emplace_back(motion);
  }
}

RadarDetection detection_at(const NpyTable& values, std::size_t row) {
  const double forward = values(row, kForward);
  const double left = values(row, kLeft);
  return {.range = std::hypot(forward, left),
          .bearing = std::atan2(left, forward),
          .range_rate = values(row, kRangeRate),
          .address = static_cast<std::int32_t>(values(row, kAddress)),
          .new_track = values(row, kNewTrack) != 0};
}

bool holds_address(const RadarScan& scan, std::optional<std::int32_t> address) {
  return std::any_of(scan.detections.begin(), scan.detections.end(),
                     [&](const RadarDetection& detection) { return detection.address == address; });
}

/// Points belong to one scan as long as they follow each other closely and no slot comes twice. A scan was
/// measured when its first point was on the bus, and received with its last.
void add_radar_scans(const ArrayLog& log, std::vector<Measurement>& measurements) {
  RadarScan scan;
  for (std::size_t row = 0; row < log.times.size(); ++row) {
    const RadarDetection detection = detection_at(log.values, row);
    const Time time = log.times[row];
    if (!scan.detections.empty() &&
        (time - scan.stamp.received_at > kScanGap || holds_address(scan, detection.address))) {
      measurements.emplace_back(std::move(scan));
      scan = {};
    }
    if (scan.detections.empty()) scan.stamp = {time, time, kCommaRadar};
    scan.stamp.received_at = time;
    scan.detections.push_back(detection);
  }
  if (!scan.detections.empty()) measurements.emplace_back(std::move(scan));
}

/// What was received at one time stays in the given order.
std::vector<Measurement> in_order_of_reception(std::vector<Measurement> measurements) {
  std::vector<std::size_t> order(measurements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return stamp_of(measurements[a]).received_at < stamp_of(measurements[b]).received_at;
  });
  std::vector<Measurement> sorted;
  sorted.reserve(measurements.size());
  for (const std::size_t i : order) sorted.push_back(std::move(measurements[i]));
  return sorted;
}

std::vector<Measurement> read_measurements(const std::filesystem::path& processed_log, Notes& notes) {
  const std::filesystem::path can = processed_log / "CAN";
  std::vector<Measurement> measurements;
  add_speeds(read_log(can / "speed", 1, {0}, notes), measurements);
  add_wheel_speeds(read_log(can / "wheel_speed", 4, {0, 1, 2, 3}, notes), measurements);
  add_yaw_rates(read_log(processed_log / "IMU" / "gyro", 3, {2}, notes), measurements);
  // Columns 3 and 4, once meant for acceleration and lateral speed, are always NaN.
  add_radar_scans(read_log(can / "radar", 7, {0, 1, 2, 5, 6}, notes), measurements);
  return in_order_of_reception(std::move(measurements));
}

Rig comma_rig() {
  return {{{.id = kCommaOdometry,
            .kind = SensorKind::odometry,
            .name = "CAN speeds and windscreen gyro",
            .mounting = {}},
           {.id = kCommaRadar,
            .kind = SensorKind::long_range_radar,
            .name = "front radar",
            .mounting = kRadarMounting}}};
}

}  // namespace

ImportedDrive import_comma2k19(const std::filesystem::path& directory) {
  const Comma2k19Segment segment = find_comma2k19_segment(directory);
  ImportedDrive drive;
  drive.info = {.name = "comma2k19 " + segment.name(), .preset_hash = {}, .witness = WitnessRule::radar_only};
  drive.rig = comma_rig();
  drive.measurements = read_measurements(segment.directory / "processed_log", drive.notes);
  drive.truth = read_comma2k19_poses(segment.directory / "global_pose", drive.notes);
  drive.notes.emplace_back(
      "witness radar_only: the drive has no camera detections, so radar alone makes a witness");
  drive.notes.emplace_back(
      fmt::format("mounting assumed: radar {} m ahead of the front axle, camera {} m behind it",
                  kRadarMounting.x, kCommaCameraBehindFrontAxle));
  return drive;
}

}  // namespace lanefuse
