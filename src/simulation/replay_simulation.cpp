// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/replay_simulation.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/object_list_model.hpp"
#include "simulation/odometry_model.hpp"

namespace lanefuse {
namespace {

std::int64_t checked_ego(const CommonRoadScenario& scenario, std::int64_t ego, const std::string& name) {
  if (!find_vehicle(scenario.vehicles, ego)) {
    throw input_error(name, fmt::format("has no recorded vehicle {}", ego),
                      "simulate --commonroad FILE --list names those there are");
  }
  return ego;
}

}  // namespace

ReplaySimulation::ReplaySimulation(const CommonRoadScenario& scenario, std::int64_t ego,
                                   const SensorPreset& preset, const std::string& name, std::uint64_t seed)
    : info_{fmt::format("replayed, {}, ego {}, seed {}", name, ego, seed), preset.hash,
            WitnessRule::radar_and_camera},
      road_(true_road(scenario.map)),
      traffic_(scenario.vehicles, checked_ego(scenario, ego, name)),
      suite_(preset.fusion_hz) {
  suite_.add(std::make_unique<OdometryModel>(preset.odometry, seed));
  suite_.add(std::make_unique<ObjectListModel>(preset, seed));
}

bool ReplaySimulation::step(std::vector<Measurement>& measurements, std::vector<TrueFrame>& truth) {
  if (over_) {
    measurements.clear();
    truth.clear();
    return false;
  }
  const Scene now = traffic_.scene(suite_.next());
  traffic_.advance(to_seconds(kTick));
  over_ = traffic_.is_over();
  suite_.look(now, over_, measurements, truth);
  return true;
}

}  // namespace lanefuse
