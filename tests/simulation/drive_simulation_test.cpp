// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/drive_simulation.hpp"

#include <map>
#include <set>

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "simulation/simulated_drive.hpp"

namespace lanefuse {
namespace {

using testing::digest;
using testing::digest_truth;
using testing::Drive;
using testing::drive;
using testing::short_drive;

TEST(DriveSimulation, SameSeedSameBytes) {
  EXPECT_EQ(digest(drive(short_drive(3))), digest(drive(short_drive(3))));
  EXPECT_EQ(digest_truth(drive(short_drive(3))), digest_truth(drive(short_drive(3))));
  EXPECT_NE(digest(drive(short_drive(3))), digest(drive(short_drive(4))));
}

TEST(DriveSimulation, NoSensorDisturbsAnother) {
  const Drive all = drive(short_drive(5));
  using Switch = bool SimulationConfig::*;
  for (const Switch off : {&SimulationConfig::serial_camera, &SimulationConfig::high_resolution_camera,
                           &SimulationConfig::objects}) {
    SimulationConfig config = short_drive(5);
    config.*off = false;
    const Drive without = drive(config);
    EXPECT_EQ(without.rig.sensors.size(), 3u);
    EXPECT_EQ(digest_truth(without), digest_truth(all));
    EXPECT_LT(without.measurements.size(), all.measurements.size());
    for (const SensorDescription& sensor : without.rig.sensors) {
      EXPECT_EQ(digest(without, sensor.id), digest(all, sensor.id)) << sensor.name;
    }
  }
}

TEST(DriveSimulation, HandsOutInOrderOfReceivingWithThePresetsLatencies) {
  const Drive drive = testing::drive(short_drive(1));
  const std::map<SensorKind, int> latency_ms{{SensorKind::odometry, 10},
                                             {SensorKind::serial_camera, 60},
                                             {SensorKind::high_resolution_camera, 80},
                                             {SensorKind::object_fusion, 40}};
  const std::map<SensorKind, double> hz{{SensorKind::odometry, 50},
                                        {SensorKind::serial_camera, 25},
                                        {SensorKind::high_resolution_camera, 12.5},
                                        {SensorKind::object_fusion, 12.5}};
  std::map<std::uint32_t, Time> last;
  Time received{};
  for (const Measurement& measurement : drive.measurements) {
    const Stamp& stamp = stamp_of(measurement);
    const SensorKind kind = drive.rig.find(stamp.sensor_id)->kind;
    ASSERT_GE(stamp.received_at, received);
    ASSERT_EQ(stamp.received_at - stamp.measured_at, std::chrono::milliseconds(latency_ms.at(kind)));
    ASSERT_FALSE(implausible(measurement)) << *implausible(measurement);
    received = stamp.received_at;
    if (last.contains(stamp.sensor_id)) {
      ASSERT_EQ(stamp.measured_at - last[stamp.sensor_id], from_seconds(1 / hz.at(kind)));
    } else {
      ASSERT_EQ(stamp.measured_at, kSimulationStart);
    }
    last[stamp.sensor_id] = stamp.measured_at;
  }
  EXPECT_EQ(last.size(), 4u);
}

TEST(DriveSimulation, NeverHandsOutAheadOfTime) {
  DriveSimulation simulation(short_drive(1), nominal_preset());
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  Time now = kSimulationStart;
  while (simulation.step(measurements, truth) && simulation.progress() < 1) {
    for (const Measurement& measurement : measurements) {
      ASSERT_LE(stamp_of(measurement).received_at, now);
      ASSERT_GT(stamp_of(measurement).received_at, now - kTick);
    }
    now += kTick;
  }
}

TEST(DriveSimulation, TruthComesAtTheFusionRateAndCoversTheWay) {
  const Drive drive = testing::drive(short_drive(2));
  ASSERT_GT(drive.truth.size(), 100u);
  for (std::size_t i = 0; i < drive.truth.size(); ++i) {
    EXPECT_EQ(drive.truth[i].time, kSimulationStart + static_cast<int>(i) * std::chrono::milliseconds(80));
  }
  double way = 0;
  for (const TrueFrame& frame : drive.truth) way += frame.speed * 0.08;
  EXPECT_NEAR(way, 600, 10);
}

TEST(DriveSimulation, TheTrueRoadReachesWhereSensorsLook) {
  DriveSimulation simulation(short_drive(2), nominal_preset());
  const TrueRoad road = simulation.road();
  const Drive drive = testing::drive(short_drive(2));
  const Pose2 end = drive.truth.back().world_from_vehicle;
  ASSERT_EQ(road.boundaries.size(), 4u);
  for (const TrueBoundary& boundary : road.boundaries) {
    EXPECT_GT((end.inverse() * boundary.points.back()).x(), 300);
    EXPECT_LT((drive.truth.front().world_from_vehicle.inverse() * boundary.points.front()).x(), -300);
  }
}

TEST(DriveSimulation, EveryFeatureAndObjectIsPlausible) {
  for (const Measurement& measurement : drive(short_drive(6)).measurements) {
    if (const auto* frame = std::get_if<MarkingFeatures>(&measurement)) {
      for (const Feature& feature : frame->features) ASSERT_TRUE(is_plausible(feature));
    }
    if (const auto* list = std::get_if<ObjectList>(&measurement)) {
      std::set<std::int64_t> ids;
      for (const TrackedObject& object : list->objects) {
        ASSERT_TRUE(is_plausible(object));
        ASSERT_TRUE(ids.insert(object.id).second);
      }
    }
  }
}

TEST(DriveSimulation, SaysWhereItComesFrom) {
  const DriveInfo info = DriveSimulation(short_drive(1), nominal_preset()).info();
  EXPECT_EQ(info.name, "simulated, seed 1, 0.6 km, gentle");
  EXPECT_EQ(info.preset_hash, nominal_preset().hash);
  EXPECT_EQ(info.witness, WitnessRule::radar_and_camera);
}

TEST(DriveSimulation, RefusesImpossibleDrives) {
  SimulationConfig config;
  config.km = 0;
  EXPECT_THROW(DriveSimulation(config, nominal_preset()), Error);
  SensorPreset preset = nominal_preset();
  preset.object_list.hz = 60;
  EXPECT_THROW(DriveSimulation(SimulationConfig{}, preset), Error);
}

}  // namespace
}  // namespace lanefuse
