// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "simulation/drive_simulation.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;

std::string refusal_of(const std::string& text) {
  try {
    parse_scenario("version: 1\n" + text, "test.yaml");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::configuration);
    return error.what();
  }
  return "accepted";
}

TEST(Scenario, EveryBuiltInOneMakesADrive) {
  const std::vector<std::string> names = built_in_scenario_names();
  EXPECT_GE(names.size(), 19u);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const std::string& name : names) {
    SimulationConfig config;
    config.km = 0.1;
    config.scenario = built_in_scenario(name);
    EXPECT_EQ(config.scenario.name, name);
    EXPECT_NE(config.scenario.about, "");
    DriveSimulation simulation(config, nominal_preset());
    std::vector<Measurement> measurements;
    std::vector<TrueFrame> truth;
    for (int tick = 0; tick < 50; ++tick) ASSERT_TRUE(simulation.step(measurements, truth)) << name;
  }
}

TEST(Scenario, TheNominalOneIsThePreset) {
  const SensorPreset preset = nominal_preset();
  const TrafficConfig config = traffic_config(built_in_scenario("nominal"), preset);
  EXPECT_EQ(config.preset.vehicles_per_metre_lane, preset.traffic.vehicles_per_metre_lane);
  EXPECT_EQ(config.ego.speed, preset.ego.speed);
  EXPECT_FALSE(config.lead_truck_gap);
}

TEST(Scenario, SaysWhatIsOtherThanThePreset) {
  const Scenario scenario = parse_scenario(R"(
version: 1
about: a test
road: {course: sharp, events: [{kind: exit, first_m: 100, every_m: 900}]}
ego: {speed_mps: 20, lane_change_every_s: never}
traffic: {vehicles_per_km_lane: 20, lead_truck_m: 40}
sensors: {objects: false}
disturbances: [{kind: latency, delay_ms: 80, sensors: [objects]}]
)",
                                           "folder/own.yaml");
  EXPECT_EQ(scenario.name, "own");
  EXPECT_EQ(scenario.road.course, RoadKind::sharp);
  ASSERT_EQ(scenario.road.events.size(), 1u);
  EXPECT_EQ(scenario.road.events[0].every, 900);
  EXPECT_FALSE(scenario.sensors.objects);
  EXPECT_DOUBLE_EQ(scenario.disturbances.at(0).delay, 0.08);
  const TrafficConfig config = traffic_config(scenario, nominal_preset());
  EXPECT_EQ(config.ego.lane_change_every, TrafficConfig::kNever);
  EXPECT_DOUBLE_EQ(config.preset.vehicles_per_metre_lane, 0.02);
  EXPECT_EQ(config.lead_truck_gap, 40);
}

TEST(Scenario, FirstGapComesAfterAsLongAsTheOthers) {
  const Scenario scenario = parse_scenario("version: 1\ndisturbances: [{kind: gaps, every_s: 30}]", "a.yaml");
  EXPECT_EQ(scenario.disturbances.at(0).first, 30);
}

TEST(Scenario, RefusalsNameFileLineAndKey) {
  EXPECT_THAT(refusal_of("ego:\n  speed: 3\n"), HasSubstr("test.yaml, line 3, ego.speed: is an unknown key"));
  EXPECT_THAT(refusal_of("ego: {speed_mps: fast}"), HasSubstr("line 2, ego.speed_mps: is not a number"));
  EXPECT_THAT(refusal_of("ego: {speed_mps: 300}"), HasSubstr("is 300, which is not in [1, 70]"));
  EXPECT_THAT(refusal_of("ego: 3"), HasSubstr("line 2, ego: is not a map"));
  EXPECT_THAT(refusal_of("road: {course: bumpy}"), HasSubstr("choose from gentle, curved, sharp"));
  EXPECT_THAT(refusal_of("road:\n  events:\n    - {first_m: 3}\n"),
              HasSubstr("line 4, road.events[1]: has no key kind"));
  EXPECT_THAT(refusal_of("road: {map: a.xodr, course: gentle}"), HasSubstr("road.course"));
  EXPECT_THAT(refusal_of("about: a\nabout: b\n"), HasSubstr("about: is there twice"));
  EXPECT_THAT(refusal_of("about: [\n"), HasSubstr("is not YAML"));
  EXPECT_THAT(refusal_of("traffic: {trucks: .nan}"), HasSubstr("is not a number"));
  EXPECT_THAT(refusal_of("disturbances: [{kind: gaps, sensors: [nose]}]"), HasSubstr("nose is not known"));
}

TEST(Scenario, EventsThatMeetAreNamedByTheirLine) {
  SimulationConfig config;
  config.scenario = parse_scenario(
      "version: 1\nroad:\n  events:\n    - {kind: exit, first_m: 600}\n    - {kind: lane_drop, first_m: "
      "700}\n",
      "test.yaml");
  EXPECT_THAT(
      [&] { DriveSimulation(config, nominal_preset()); },
      testing::ThrowsMessage<Error>(HasSubstr("test.yaml, line 5, road.events[2]: the exit from 600 m")));
}

TEST(Scenario, RefusesOtherVersionsAndWhatIsNoMap) {
  EXPECT_THROW(parse_scenario("version: 2", "x.yaml"), Error);
  EXPECT_THROW(parse_scenario("about: no version", "x.yaml"), Error);
  EXPECT_THROW(parse_scenario("- 1", "x.yaml"), Error);
  EXPECT_THROW(parse_scenario("", "x.yaml"), Error);
  EXPECT_THROW(built_in_scenario("no-such-thing"), Error);
  EXPECT_THROW(load_scenario("/nowhere/x.yaml"), Error);
}

}  // namespace
}  // namespace lanefuse
