// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/broken_detections.hpp"
#include "pipeline/damaged_stream.hpp"

/// Which sensor is named on drives that no setting was tried on.
namespace lanefuse {
namespace {

using testing::broken_camera;
using testing::broken_radar;
using testing::CycleResult;
using testing::detected_drive;
using testing::expect_blamed;
using testing::Fault;
using testing::flagged_after;
using testing::image_width;
using testing::mirror;
using testing::run;
using testing::seconds_of;
using testing::SimulatedDrive;

/// [s] For which each sensor was named.
std::map<std::uint32_t, double> named(const std::vector<CycleResult>& cycles) {
  std::map<std::uint32_t, double> seconds;
  for (const CycleResult& cycle : cycles) {
    for (const std::uint32_t id : cycle.distrusted) seconds[id] += 0.08;
  }
  return seconds;
}

/// The simulator's own detections, of things that stand in the world as the car turns.
SimulatedDrive simulated_detections(std::uint64_t seed, double km) {
  SimulationConfig config{seed, km};
  config.detections = true;
  return testing::simulate(config);
}

std::uint32_t id_of(const SimulatedDrive& drive, SensorKind kind) {
  return std::ranges::find(drive.rig.sensors, kind, &SensorDescription::kind)->id;
}

class FaultsOnOtherDrives : public ::testing::TestWithParam<std::uint64_t> {};

/// The camera stands alone against radars that prove themselves; until one has, the radar may be named.
TEST_P(FaultsOnOtherDrives, EndWithTheMirroredCameraNamed) {
  const SimulatedDrive drive = simulated_detections(GetParam(), 0.5);
  const auto stream = broken_camera(drive, [&](CameraBoxes& boxes) { mirror(boxes, image_width(drive)); });
  const auto cycles = run(drive.rig, stream);
  EXPECT_THAT(cycles.back().distrusted, ::testing::ElementsAre(id_of(drive, SensorKind::object_camera)));
}

TEST_P(FaultsOnOtherDrives, NameNobodyButTheTurnedSensor) {
  const SimulatedDrive drive = simulated_detections(GetParam(), 0.5);
  for (const SensorKind kind : {SensorKind::long_range_radar, SensorKind::short_range_radar}) {
    const std::uint32_t sensor = id_of(drive, kind);
    for (const double turn : {-0.12, 0.12}) {
      const auto seconds = named(run(drive.rig, broken_radar(drive, sensor, [&](RadarScan& scan) {
                                       for (RadarDetection& d : scan.detections) d.bearing += turn;
                                     })));
      EXPECT_EQ(seconds.size(), 1U) << sensor << " by " << turn;
      EXPECT_TRUE(seconds.contains(sensor)) << sensor << " by " << turn;
    }
  }
}

TEST_P(FaultsOnOtherDrives, NameNobodyButTheBlindSensor) {
  const SimulatedDrive drive = simulated_detections(GetParam(), 0.5);
  const std::uint32_t radar = id_of(drive, SensorKind::long_range_radar);
  for (const auto& [id, of] :
       named(run(drive.rig, broken_radar(drive, radar, [](RadarScan& scan) { scan.detections.clear(); })))) {
    EXPECT_EQ(id, radar);
  }
  const auto stream = broken_camera(drive, [](CameraBoxes& boxes) { boxes.boxes.clear(); });
  for (const auto& [id, of] : named(run(drive.rig, stream))) {
    EXPECT_EQ(id, id_of(drive, SensorKind::object_camera));
  }
}

TEST_P(FaultsOnOtherDrives, AreNoneWhereNothingIsBroken) {
  const SimulatedDrive drive = simulated_detections(GetParam(), 1);
  EXPECT_TRUE(named(run(drive.rig, drive.measurements)).empty());
}

TEST_P(FaultsOnOtherDrives, AreFlaggedInTimeWhateverTheUnits) {
  const SimulatedDrive drive = detected_drive(GetParam());
  const std::vector<std::pair<const char*, Fault>> faults{{"degrees",
                                                           [](RadarScan& scan) {
                                                             for (RadarDetection& d : scan.detections)
                                                               d.bearing *= 180 / 3.14159265358979;
                                                           }},
                                                          {"kilometres an hour",
                                                           [](RadarScan& scan) {
                                                             for (RadarDetection& d : scan.detections)
                                                               d.range_rate *= 3.6;
                                                           }},
                                                          {"mirrored", [](RadarScan& scan) {
                                                             for (RadarDetection& d : scan.detections)
                                                               d.bearing = -d.bearing;
                                                           }}};
  for (const std::uint32_t sensor : {testing::kFrontRadar, testing::kLeftRadar}) {
    for (const auto& [name, fault] : faults) {
      const auto cycles = run(drive.rig, broken_radar(drive, sensor, fault));
      EXPECT_GT(flagged_after(cycles), 0) << name;
      // A mirror image must show something aside first.
      const double limit = name == std::string_view("mirrored") ? 4 : 2;
      EXPECT_LT(flagged_after(cycles), limit) << name << ", " << sensor;
      expect_blamed(cycles, sensor);
    }
  }
}

/// The whole car's clock: lanes are invalid from the second cycle on, and valid ten cycles after the first
/// stamp of the new clock.
TEST_P(FaultsOnOtherDrives, EndTenCyclesAfterTheClockIsSet) {
  constexpr double kSet = 5;
  constexpr double kCycle = 0.08;
  const SimulatedDrive drive = detected_drive(GetParam());
  for (const double jump : {-86400.0, -5.0, -0.5, 0.5, 5.0, 86400.0}) {
    std::vector<Measurement> stream = drive.measurements;
    for (Measurement& measurement : stream) {
      Stamp& stamp = testing::stamp_in(measurement);
      if (seconds_of(stamp.received_at) < kSet) continue;
      stamp.measured_at += from_seconds(jump);
      stamp.received_at += from_seconds(jump);
    }
    const auto cycles = run(drive.rig, stream);
    const auto flagged = std::ranges::find_if(cycles, [&](const CycleResult& cycle) {
      const double seconds = seconds_of(cycle.lanes.time);
      return (seconds > 4 || std::abs(jump) > 4) && cycle.lanes.status == EstimateStatus::invalid &&
             &cycle - cycles.data() > 40;
    });
    ASSERT_NE(flagged, cycles.end()) << jump;
    EXPECT_LT(seconds_of((flagged - 1)->lanes.time), kSet + kCycle) << jump;
    const auto valid = std::find_if(flagged, cycles.end(), [](const CycleResult& cycle) {
      return cycle.lanes.status == EstimateStatus::ok && !cycle.lanes.lanes.empty();
    });
    ASSERT_NE(valid, cycles.end()) << jump;
    EXPECT_LT(seconds_of(valid->lanes.time), kSet + jump + 10 * kCycle + 0.001) << jump;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FaultsOnOtherDrives, ::testing::Values(2, 4, 6));

}  // namespace
}  // namespace lanefuse
