// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/drive_simulation.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

struct Drive {
  Rig rig;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
};

Drive drive(const SimulationConfig& config) {
  DriveSimulation simulation(config, nominal_preset());
  Drive drive{simulation.rig(), {}, {}};
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  while (simulation.step(measurements, truth)) {
    drive.measurements.insert(drive.measurements.end(), measurements.begin(), measurements.end());
    drive.truth.insert(drive.truth.end(), truth.begin(), truth.end());
  }
  return drive;
}

SimulationConfig short_drive(std::uint64_t seed) {
  SimulationConfig config;
  config.seed = seed;
  config.km = 0.6;
  return config;
}

/// Every bit of some numbers that a message carries.
class Digest {
 public:
  void operator()(const VehicleMotion& m) { add({*m.speed, *m.yaw_rate}); }
  void operator()(const SerialLane& m) {
    for (const auto* side : {&m.left, &m.right}) {
      if (*side) add({(*side)->clothoid.y(50), (*side)->covariance.sum(), (*side)->range_end});
    }
  }
  void operator()(const MarkingFeatures& m) {
    for (const Feature& f : m.features) add({f.x, f.y, f.heading, f.covariance.sum()});
  }
  void operator()(const ObjectList& m) {
    for (const TrackedObject& o : m.objects) add({o.x, o.y, o.heading, o.speed, double(o.seen_by_camera)});
  }
  void operator()(const RadarScan& m) {
    for (const RadarDetection& d : m.detections) add({d.range, d.bearing, d.range_rate});
  }
  void operator()(const CameraBoxes& m) {
    for (const BoxDetection& b : m.boxes) add({b.left, b.top, b.right, b.bottom, b.confidence});
  }
  void operator()(const CameraImage& m) {
    text_.append(reinterpret_cast<const char*>(m.bytes.data()), m.bytes.size());
  }
  void operator()(const GnssInsFix& m) { add({m.latitude, m.longitude, m.height, m.heading}); }
  void add(std::initializer_list<double> numbers) {
    for (const double number : numbers) text_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  [[nodiscard]] std::size_t value() const { return std::hash<std::string>{}(text_); }

 private:
  std::string text_;
};

std::size_t digest(const Drive& drive, std::optional<std::uint32_t> sensor = {}) {
  Digest digest;
  for (const Measurement& measurement : drive.measurements) {
    if (!sensor || stamp_of(measurement).sensor_id == *sensor) std::visit(digest, measurement);
  }
  return digest.value();
}

std::size_t digest_truth(const Drive& drive) {
  Digest digest;
  for (const TrueFrame& frame : drive.truth) {
    digest.add({frame.world_from_vehicle.x, frame.world_from_vehicle.y, frame.speed, frame.yaw_rate});
    for (const TrueObject& object : frame.objects) digest.add({object.world_from_object.x, object.speed});
  }
  return digest.value();
}

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
  const Drive drive = lanefuse::drive(short_drive(1));
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
  const Drive drive = lanefuse::drive(short_drive(2));
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
  const Drive drive = lanefuse::drive(short_drive(2));
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

SimulationConfig with_detections(std::uint64_t seed) {
  SimulationConfig config = short_drive(seed);
  config.detections = true;
  return config;
}

TEST(DriveSimulation, DetectionsStandInForTheObjectListAndDisturbNoSensor) {
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

TEST(DriveSimulation, MirrorsAddGhostsAndChangeNoOtherDetection) {
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

TEST(DriveSimulation, EveryDetectionIsPlausibleAndNamed) {
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
