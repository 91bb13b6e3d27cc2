// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "simulation/simulated_drive.hpp"

namespace lanefuse {
namespace {

using testing::digest;
using testing::digest_truth;
using testing::Drive;
using testing::drive;
using testing::short_drive;

SimulationConfig with_detections(std::uint64_t seed) {
  SimulationConfig config = short_drive(seed);
  config.detections = true;
  return config;
}

TEST(DetectionDrive, DetectionsStandInForTheObjectListAndDisturbNoSensor) {
  const Drive lists = drive(short_drive(5));
  const Drive detections = drive(with_detections(5));
  std::multiset<SensorKind> kinds;
  std::set<std::uint32_t> ids;
  for (const SensorDescription& sensor : detections.rig.sensors) {
    kinds.insert(sensor.kind);
    EXPECT_TRUE(ids.insert(sensor.id).second);
  }
  EXPECT_EQ(kinds.count(SensorKind::long_range_radar), 1u);
  EXPECT_EQ(kinds.count(SensorKind::short_range_radar), 4u);
  EXPECT_EQ(kinds.count(SensorKind::object_camera), 1u);
  EXPECT_EQ(kinds.count(SensorKind::object_fusion), 0u);
  EXPECT_EQ(digest_truth(detections), digest_truth(lists));
  for (const std::uint32_t id : {1u, 2u, 3u}) EXPECT_EQ(digest(detections, id), digest(lists, id));
  EXPECT_EQ(digest(detections), digest(drive(with_detections(5))));
  SimulationConfig none = with_detections(5);
  none.objects = false;
  EXPECT_EQ(drive(none).rig.sensors.size(), 3u);
}

TEST(DetectionDrive, MirrorsAddGhostsAndChangeNoOtherDetection) {
  SimulationConfig config = with_detections(5);
  config.guard_rail_mirrors = 0;
  const Drive without = drive(config);
  config.guard_rail_mirrors = 20;
  const Drive with = drive(config);
  ASSERT_EQ(with.measurements.size(), without.measurements.size());
  std::size_t ghosts = 0;
  for (std::size_t i = 0; i < with.measurements.size(); ++i) {
    const auto* scan = std::get_if<RadarScan>(&with.measurements[i]);
    if (!scan) continue;
    const auto& real = std::get<RadarScan>(without.measurements[i]).detections;
    const auto is_there = [&](const RadarDetection& detection) {
      return std::ranges::any_of(scan->detections, [&](const RadarDetection& other) {
        return other.range == detection.range && other.bearing == detection.bearing;
      });
    };
    ASSERT_TRUE(std::ranges::all_of(real, is_there));
    ghosts += scan->detections.size() - real.size();
  }
  EXPECT_GT(ghosts, 100u);
}

TEST(DetectionDrive, EveryDetectionIsPlausibleAndNamed) {
  const Drive all = drive(with_detections(6));
  std::map<SensorKind, double> messages, detections;
  for (const Measurement& measurement : all.measurements) {
    const SensorKind kind = all.rig.find(stamp_of(measurement).sensor_id)->kind;
    messages[kind] += 1;
    if (const auto* scan = std::get_if<RadarScan>(&measurement)) {
      for (const RadarDetection& detection : scan->detections) ASSERT_TRUE(is_plausible(detection));
      detections[kind] += static_cast<double>(scan->detections.size());
    }
    if (const auto* boxes = std::get_if<CameraBoxes>(&measurement)) {
      for (const BoxDetection& box : boxes->boxes) ASSERT_TRUE(is_plausible(box));
      detections[kind] += static_cast<double>(boxes->boxes.size());
    }
  }
  EXPECT_NEAR(messages[SensorKind::long_range_radar] / messages[SensorKind::odometry], 15.0 / 50, 0.005);
  EXPECT_NEAR(messages[SensorKind::short_range_radar] / messages[SensorKind::odometry], 4 * 20.0 / 50, 0.01);
  EXPECT_GT(detections[SensorKind::long_range_radar] / messages[SensorKind::long_range_radar], 4);
  EXPECT_GT(detections[SensorKind::short_range_radar] / messages[SensorKind::short_range_radar], 3);
  EXPECT_GT(detections[SensorKind::object_camera] / messages[SensorKind::object_camera], 0.5);
  SimulationConfig config = with_detections(6);
  config.guard_rail_mirrors = 3;
  EXPECT_EQ(DriveSimulation(config, nominal_preset()).info().name,
            "simulated, seed 6, 0.6 km, gentle, detections, up to 3 guard-rail mirrors");
}

}  // namespace
}  // namespace lanefuse
