// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <vector>

#include "importing/npy_writer.hpp"

namespace lanefuse::testing {

/// A small comma2k19 segment: two seconds from longitude 0 on the equator due north at 20 m/s, with a camera
/// that looks `kMountingYaw` too far to the left. There, east is ECEF's y, north is z and up is x.
struct SyntheticSegment {
  static constexpr double kStart = 1000;        ///< [s]
  static constexpr double kSpeed = 20;          ///< [m/s]
  static constexpr double kMountingYaw = 0.02;  ///< [rad]
  static constexpr double kTurnRight = 0.03;    ///< [rad/s] what the gyro reads about its axis down
  static constexpr std::size_t kScans = 40;

  std::filesystem::path directory;

  explicit SyntheticSegment(std::filesystem::path where) : directory(std::move(where)) {
    write_bus();
    write_poses();
  }

 private:
  void write_log(const std::filesystem::path& name, const std::vector<double>& times,
                 const std::vector<std::vector<double>>& values) const {
    write_list(directory / "processed_log" / name / "t", times);
    write_table(directory / "processed_log" / name / "value", values);
  }

  void write_bus() const {
    std::vector<double> times;
    std::vector<double> radar_times;
    std::vector<std::vector<double>> radar;
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t scan = 0; scan < kScans; ++scan) {
      const double time = kStart + 0.05 * static_cast<double>(scan);
      times.push_back(time);
      radar_times.insert(radar_times.end(), {time, time + 0.004});
      radar.push_back({40, 3, -2, kNone, kNone, 528, scan == 0 ? 1.0 : 0.0});
      radar.push_back({60, -4, 1, kNone, kNone, 529, 0});
    }
    write_log("CAN/radar", radar_times, radar);
    write_log("CAN/speed", times, std::vector<std::vector<double>>(kScans, {kSpeed}));
    write_log("CAN/wheel_speed", times, std::vector<std::vector<double>>(kScans, {19, 20, 21, 22}));
    write_log("IMU/gyro", times, std::vector<std::vector<double>>(kScans, {0.1, 0.2, kTurnRight}));
  }

  void write_poses() const {
    std::vector<double> times;
    std::vector<std::vector<double>> positions;
    // Forward, right, down of a camera that looks north: ECEF's z, y, -x. A turn by yaw about up changes them
    // to columns (0, -sin, cos), (0, cos, sin), (-1, 0, 0), whose quaternion is the product of the two turns
    // below.
    const double half = kMountingYaw / 2;
    const double root = std::sqrt(0.5);
    const std::vector<double> orientation = {root * std::cos(half), root * std::sin(half),
                                             -root * std::cos(half), root * std::sin(half)};
    for (std::size_t frame = 0; frame < kScans; ++frame) {
      const double seconds = 0.05 * static_cast<double>(frame);
      times.push_back(kStart + seconds);
      positions.push_back({6378137, 0, kSpeed * seconds});
    }
    write_list(directory / "global_pose/frame_times", times);
    write_table(directory / "global_pose/frame_positions", positions);
    write_table(directory / "global_pose/frame_velocities",
                std::vector<std::vector<double>>(kScans, {0, 0, kSpeed}));
    write_table(directory / "global_pose/frame_orientations",
                std::vector<std::vector<double>>(kScans, orientation));
  }
};

}  // namespace lanefuse::testing
