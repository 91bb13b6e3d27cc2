// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "roadmap/commonroad.hpp"
#include "sensors/drive.hpp"
#include "simulation/preset.hpp"
#include "simulation/recorded_traffic.hpp"
#include "simulation/sensor_suite.hpp"

namespace lanefuse {

/// What is replayed of a recorded scenario, and how.
struct ReplayConfig {
  std::string name;         ///< says where the scenario comes from
  std::int64_t ego = 0;     ///< id of the recorded vehicle that is the ego car
  std::uint64_t seed = 1;   ///< the same seed gives the same bytes
  bool detections = false;  ///< radars' reflections and a camera's boxes instead of the object list
  std::optional<int> guard_rail_mirrors = {};  ///< as SimulationConfig's
};

/// A drive of one recorded vehicle among the others that were recorded with it: its odometry, the others as
/// an object list with the preset's errors or as detections, and the recorded road as truth. For radars,
/// guard rails stand beyond its outermost boundaries. There are no cameras that see lines, as nobody recorded
/// the paint.
class ReplaySimulation {
 public:
  /// Throws an input error where no vehicle has the ego car's id.
  ReplaySimulation(const CommonRoadScenario& scenario, const ReplayConfig& config,
                   const SensorPreset& preset);

  [[nodiscard]] Rig rig() const { return suite_.rig(); }
  [[nodiscard]] const DriveInfo& info() const { return info_; }
  [[nodiscard]] const TrueRoad& road() const { return road_; }

  /// As DriveSimulation::step.
  bool step(std::vector<Measurement>& measurements, std::vector<TrueFrame>& truth);
  [[nodiscard]] double progress() const { return traffic_.progress(); }

 private:
  DriveInfo info_;
  TrueRoad road_;
  RecordedTraffic traffic_;
  SensorSuite suite_;
  bool over_ = false;

  void add_objects(const ReplayConfig& config, const SensorPreset& preset);
};

}  // namespace lanefuse
