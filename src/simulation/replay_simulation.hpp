// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "roadmap/commonroad.hpp"
#include "sensors/drive.hpp"
#include "simulation/preset.hpp"
#include "simulation/recorded_traffic.hpp"
#include "simulation/sensor_suite.hpp"

namespace lanefuse {

/// A drive of one recorded vehicle among the others that were recorded with it: its odometry, the others as
/// an object list with the preset's errors, and the recorded road as truth. There are no cameras that see
/// lines, as nobody recorded the paint.
class ReplaySimulation {
 public:
  /// `name` says where the scenario comes from. Throws an input error where no vehicle has the id.
  ReplaySimulation(const CommonRoadScenario& scenario, std::int64_t ego, const SensorPreset& preset,
                   const std::string& name, std::uint64_t seed);

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
};

}  // namespace lanefuse
