// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <gtest/gtest.h>

#include "support/detected_drive.hpp"

/// Drives whose radars or camera of vehicles break, and what is said of it.
namespace lanefuse::testing {

inline SourceStatus objects_of(const CycleResult& cycle) {
  return cycle.lanes.sources[static_cast<std::size_t>(Source::objects)];
}

/// What breaks a radar's detections from second 4 on.
using Fault = std::function<void(RadarScan&)>;
inline constexpr double kBegin = 4;

inline std::vector<Measurement> broken_radar(const SimulatedDrive& drive, std::uint32_t sensor,
                                             const Fault& fault) {
  std::vector<Measurement> stream = drive.measurements;
  for (Measurement& measurement : stream) {
    auto* scan = std::get_if<RadarScan>(&measurement);
    if (scan && scan->stamp.sensor_id == sensor && seconds_of(scan->stamp.measured_at) >= kBegin)
      fault(*scan);
  }
  return stream;
}

/// [s] After the beginning, when objects are first said to be degraded; 99 for never.
inline double flagged_after(const std::vector<CycleResult>& cycles) {
  for (const CycleResult& cycle : cycles) {
    if (objects_of(cycle) == SourceStatus::degraded) return seconds_of(cycle.lanes.time) - kBegin;
  }
  return 99;
}

/// That no other sensor is blamed for what one of them did.
inline void expect_blamed(const std::vector<CycleResult>& cycles, std::uint32_t sensor) {
  bool blamed = false;
  for (const CycleResult& cycle : cycles) {
    blamed = blamed || !cycle.distrusted.empty();
    for (const std::uint32_t id : cycle.distrusted) EXPECT_EQ(id, sensor) << seconds_of(cycle.lanes.time);
  }
  EXPECT_TRUE(blamed) << sensor;
}

inline std::vector<Measurement> broken_camera(const SimulatedDrive& drive,
                                              const std::function<void(CameraBoxes&)>& fault) {
  std::vector<Measurement> stream = drive.measurements;
  for (Measurement& measurement : stream) {
    auto* boxes = std::get_if<CameraBoxes>(&measurement);
    if (boxes && seconds_of(boxes->stamp.measured_at) >= kBegin) fault(*boxes);
  }
  return stream;
}

inline double image_width(const SimulatedDrive& drive) {
  return std::ranges::find(drive.rig.sensors, SensorKind::object_camera, &SensorDescription::kind)
      ->camera->width;
}

inline void mirror(CameraBoxes& boxes, double width) {
  for (BoxDetection& box : boxes.boxes) {
    box = {width - 1 - box.right, box.top, width - 1 - box.left, box.bottom, box.confidence};
  }
}

}  // namespace lanefuse::testing
