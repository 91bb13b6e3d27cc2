// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"
#include "sensors/truth.hpp"
#include "simulation/drive_road.hpp"
#include "simulation/image_conditions.hpp"
#include "simulation/preset.hpp"
#include "simulation/road_as_map.hpp"
#include "simulation/scenario.hpp"
#include "simulation/sensor_suite.hpp"
#include "simulation/traffic.hpp"

namespace lanefuse {

struct SimulationConfig {
  std::uint64_t seed = 1;            ///< the same seed gives the same bytes
  double km = 2;                     ///< that the ego car drives, in (0, 4000]
  RoadKind road = RoadKind::gentle;  ///< where the scenario does not say
  /// Odometry is always there. Road, traffic and the other sensors do not change when one is switched off.
  bool serial_camera = true;
  bool high_resolution_camera = true;
  bool objects = true;
  bool detections = false;  ///< radars' reflections and a camera's boxes instead of the object list
  std::optional<int> guard_rail_mirrors;   ///< most ghosts beside guard rails a scan; else the preset's
  bool gnss_ins = false;                   ///< only for surveys; the drive then says where on Earth it is
  std::optional<std::uint64_t> road_seed;  ///< else `seed`; so that many drives share a road
  std::optional<int> ego_lane;             ///< to start in, from the left, from zero; else the middle one
  bool ego_lane_changes = true;            ///< whether the ego car may leave its lane
  /// Sensors err so many times as much as the preset says, and as they state: see with_noise(). What is drawn
  /// into rendered images stays.
  double noise = 1;
  /// The cameras hand over rendered images instead of what they found in them.
  std::optional<ImageConditions> images;
  bool sumo = false;  ///< SUMO's traffic instead of the built-in drivers
  Scenario scenario;  ///< the nominal one, if nothing is said; what it leaves out is off, too
};

/// A simulated drive on a motorway, with exact truth. Runs in steps of kTick; nothing but the road grows with
/// its length (some 130 bytes a metre).
class DriveSimulation {
 public:
  /// Throws a configuration error where the configuration or the preset's rates are impossible.
  DriveSimulation(const SimulationConfig& config, const SensorPreset& preset);

  [[nodiscard]] const Scenario& scenario() const { return config_.scenario; }
  [[nodiscard]] Rig rig() const { return suite_.rig(); }
  [[nodiscard]] DriveInfo info() const;
  [[nodiscard]] TrueRoad road() const { return true_road(drive_road_->road); }
  /// The road as a map of the simulated world.
  [[nodiscard]] RoadMap map() const;

  /// Moves on by one tick, and replaces the contents of `measurements` by what was received in it, in the
  /// order of receiving, and of `truth` by how things were at the preset's fusion rate. False once the drive
  /// is over; what is still on its way then comes with the last step.
  bool step(std::vector<Measurement>& measurements, std::vector<TrueFrame>& truth);

  /// How much of the way is done, in [0, 1].
  [[nodiscard]] double progress() const;

 private:
  SimulationConfig config_;
  SensorPreset preset_;
  std::unique_ptr<const DriveRoad> drive_road_;  ///< in one place, as traffic and scene refer to it
  std::unique_ptr<TrafficModel> traffic_;
  double ego_station_;  ///< [m]
  SensorSuite suite_;
  bool over_ = false;

  void add_sensors();
  void add_objects();
  void add_cameras();
  void add_sensor(std::unique_ptr<SensorModel> sensor);
};

}  // namespace lanefuse
