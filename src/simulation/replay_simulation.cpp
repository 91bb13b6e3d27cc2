// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/replay_simulation.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/detection_sensors.hpp"
#include "simulation/object_list_model.hpp"
#include "simulation/odometry_model.hpp"

namespace lanefuse {
namespace {

std::int64_t checked_ego(const CommonRoadScenario& scenario, const ReplayConfig& config) {
  if (!find_vehicle(scenario.vehicles, config.ego)) {
    throw input_error(config.name, fmt::format("has no recorded vehicle {}", config.ego),
                      "simulate --commonroad FILE --list names those there are");
  }
  return config.ego;
}

std::string name_of(const ReplayConfig& config) {
  std::string name = fmt::format("replayed, {}, ego {}, seed {}", config.name, config.ego, config.seed);
  if (config.detections) name += detections_in_name(config.guard_rail_mirrors);
  return name;
}

}  // namespace

ReplaySimulation::ReplaySimulation(const CommonRoadScenario& scenario, const ReplayConfig& config,
                                   const SensorPreset& preset)
    : info_{name_of(config), preset.hash, WitnessRule::radar_and_camera},
      road_(true_road(scenario.map)),
      traffic_(scenario.vehicles, checked_ego(scenario, config)),
      suite_(preset.fusion_hz) {
  suite_.add(std::make_unique<OdometryModel>(preset.odometry, config.seed));
  add_objects(config, preset);
}

void ReplaySimulation::add_objects(const ReplayConfig& config, const SensorPreset& preset) {
  if (!config.detections) return suite_.add(std::make_unique<ObjectListModel>(preset, config.seed));
  const double beyond = preset.road.shoulder + preset.road.guard_rail;
  const auto rails = std::make_shared<BoundaryRails>(road_, beyond);
  for (auto& sensor : detection_sensors(preset, rails, config.guard_rail_mirrors, config.seed)) {
    suite_.add(std::move(sensor));
  }
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
