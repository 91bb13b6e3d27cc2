// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario.hpp"

#include <array>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/scenario_section.hpp"

namespace lanefuse {
namespace {

constexpr double kMilli = 1e-3;
constexpr std::uintmax_t kLargestFile = 1 << 20;  ///< [byte] no scenario is so long

constexpr std::array kCourses{"gentle", "curved", "sharp"};
constexpr std::array kEvents{"exit", "entry", "lane_drop", "construction", "missing_paint", "rail_ghosts"};
constexpr std::array kLines{"all", "right_of_ego"};
constexpr std::array kDisturbances{"gaps", "latency", "stale", "shuffled", "blackout", "short_range"};
constexpr std::array kSensors{"serial_camera", "high_resolution_camera", "objects"};
constexpr std::array kSensorKinds{SensorKind::serial_camera, SensorKind::high_resolution_camera,
                                  SensorKind::object_fusion};

constexpr Range kPlace{0, 1e6};      ///< [m]
constexpr Range kSpeed{1, 70};       ///< [m/s]
constexpr Range kSeconds{1, 10000};  ///< [s] between lane changes

RoadEvent read_event(ScenarioSection section) {
  RoadEvent event;
  event.place = section.place_of("");
  event.kind = static_cast<RoadEvent::Kind>(section.needed_choice("kind", kEvents));
  event.first = section.number("first_m", kPlace).value_or(event.first);
  event.every = section.number("every_m", {100, 1e6}).value_or(event.every);
  const bool fixed = event.kind == RoadEvent::Kind::exit || event.kind == RoadEvent::Kind::entry;
  if (!fixed) event.length = section.number("length_m", {300, 1e6}).value_or(0);
  if (event.kind == RoadEvent::Kind::missing_paint) {
    event.share = section.number("share", {0.01, 1}).value_or(event.share);
    event.lines = static_cast<RoadEvent::Lines>(section.choice("lines", kLines).value_or(0));
  }
  section.finish();
  return event;
}

void read_road(ScenarioSection section, Scenario::RoadPart& road) {
  if (const auto course = section.choice("course", kCourses)) road.course = static_cast<RoadKind>(*course);
  if (const auto map = section.text("map")) road.map = *map;
  for (ScenarioSection& event : section.list("events")) road.events.push_back(read_event(std::move(event)));
  section.finish();
  if (road.map && road.course) section.refuse("course", "is said of a road that comes from a map");
  if (road.map && !road.events.empty()) section.refuse("events", "are only for roads without a map");
}

StopAndGo read_stop_and_go(ScenarioSection section) {
  StopAndGo profile;
  profile.fast = section.number("fast_mps", kSpeed).value_or(profile.fast);
  profile.slow = section.number("slow_mps", {0, kSpeed.high}).value_or(profile.slow);
  profile.period = section.number("period_s", {5, 3600}).value_or(profile.period);
  section.finish();
  if (profile.slow > profile.fast) section.refuse("slow_mps", "is above fast_mps");
  return profile;
}

void read_ego(ScenarioSection section, Scenario::EgoPart& ego) {
  ego.speed = section.number("speed_mps", kSpeed);
  ego.lane_change_every = section.number_or_never("lane_change_every_s", kSeconds);
  if (const auto profile = section.section("stop_and_go")) ego.stop_and_go = read_stop_and_go(*profile);
  section.finish();
}

void read_traffic(ScenarioSection section, Scenario::TrafficPart& traffic) {
  if (const auto density = section.number("vehicles_per_km_lane", {0, 80})) {
    traffic.vehicles_per_metre_lane = *density * kMilli;
  }
  traffic.trucks = section.number("trucks", {0, 1});
  traffic.lane_change_every = section.number_or_never("lane_change_every_s", kSeconds);
  traffic.jam_speed = section.number("jam_speed_mps", kSpeed);
  traffic.lead_truck_gap = section.number("lead_truck_m", {10, 150});
  section.finish();
}

void read_sensors(ScenarioSection section, Scenario::SensorsPart& sensors) {
  sensors.serial_camera = section.flag("serial_camera").value_or(true);
  sensors.high_resolution_camera = section.flag("high_resolution_camera").value_or(true);
  sensors.objects = section.flag("objects").value_or(true);
  section.finish();
}

void read_delay(ScenarioSection& section, Disturbance& disturbance) {
  disturbance.delay = section.needed_number("delay_ms", {0, 10000}) * kMilli;
  if (disturbance.kind != Disturbance::Kind::latency) {
    disturbance.share = section.number("share", {0, 1}).value_or(disturbance.share);
  }
}

Disturbance read_disturbance(ScenarioSection section) {
  Disturbance disturbance;
  disturbance.kind = static_cast<Disturbance::Kind>(section.needed_choice("kind", kDisturbances));
  for (const std::size_t i : section.choices("sensors", kSensors))
    disturbance.sensors.push_back(kSensorKinds[i]);
  switch (disturbance.kind) {
    case Disturbance::Kind::gaps:
      disturbance.every = section.number("every_s", {0.1, 1e5}).value_or(disturbance.every);
      disturbance.first = section.number("first_s", {0, 1e5}).value_or(disturbance.every);
      disturbance.length = section.number("length_s", {0, 1e5}).value_or(disturbance.length);
      break;
    case Disturbance::Kind::blackout:
      disturbance.first = section.number("first_m", kPlace).value_or(500);
      disturbance.every = section.number("every_m", {1, 1e6}).value_or(0);
      disturbance.length = section.needed_number("length_m", {1, 1e6});
      break;
    case Disturbance::Kind::short_range:
      disturbance.visibility = section.needed_number("visibility_m", {0, 1000});
      break;
    default:
      read_delay(section, disturbance);
  }
  section.finish();
  return disturbance;
}

YAML::Node parse_yaml(std::string_view text, const std::string& place) {
  try {
    return YAML::Load(std::string(text));
  } catch (const YAML::Exception& error) {
    throw configuration_error(fmt::format("{}, line {}", place, error.mark.line + 1),
                              fmt::format("is not YAML: {}", error.msg));
  }
}

}  // namespace

Scenario parse_scenario(std::string_view text, const std::string& place) {
  ScenarioSection file(parse_yaml(text, place), place);
  Scenario scenario;
  scenario.name = std::filesystem::path(place).stem().string();
  if (file.needed_number("version", {0, 1e6}) != 1) {
    file.refuse("version", "is not known", "this program reads version 1");
  }
  scenario.about = file.text("about").value_or("");
  if (const auto road = file.section("road")) read_road(*road, scenario.road);
  if (const auto ego = file.section("ego")) read_ego(*ego, scenario.ego);
  if (const auto traffic = file.section("traffic")) read_traffic(*traffic, scenario.traffic);
  if (const auto sensors = file.section("sensors")) read_sensors(*sensors, scenario.sensors);
  for (const ScenarioSection& disturbance : file.list("disturbances")) {
    scenario.disturbances.push_back(read_disturbance(disturbance));
  }
  file.finish();
  return scenario;
}

Scenario load_scenario(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw configuration_error(path.string(), "cannot be read");
  if (std::filesystem::file_size(path) > kLargestFile) {
    throw configuration_error(path.string(), "is too large for a scenario");
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Scenario scenario = parse_scenario(text, path.string());
  if (scenario.road.map) scenario.road.map = path.parent_path() / *scenario.road.map;
  return scenario;
}

TrafficConfig traffic_config(const Scenario& scenario, const SensorPreset& preset) {
  TrafficConfig config = nominal_traffic(preset);
  config.preset.vehicles_per_metre_lane =
      scenario.traffic.vehicles_per_metre_lane.value_or(config.preset.vehicles_per_metre_lane);
  config.preset.trucks = scenario.traffic.trucks.value_or(config.preset.trucks);
  config.preset.lane_change_every =
      scenario.traffic.lane_change_every.value_or(config.preset.lane_change_every);
  config.ego.speed = scenario.ego.speed.value_or(config.ego.speed);
  config.ego.lane_change_every = scenario.ego.lane_change_every.value_or(config.ego.lane_change_every);
  config.ego_stop_and_go = scenario.ego.stop_and_go;
  config.jam_speed = scenario.traffic.jam_speed;
  config.lead_truck_gap = scenario.traffic.lead_truck_gap;
  return config;
}

}  // namespace lanefuse
