// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "simulation/scene_run.hpp"
#include "simulation/traffic.hpp"
#include "simulation/varied_road.hpp"

namespace lanefuse {
namespace {

using testing::Moments;
using testing::VariedRoad;

constexpr double kTickSeconds = 0.02;

TrafficConfig traffic_of(double vehicles_per_km_lane) {
  TrafficConfig config = nominal_traffic(nominal_preset());
  config.preset.vehicles_per_metre_lane = vehicles_per_km_lane / 1000;
  return config;
}

bool overlap(const SceneVehicle& a, const SceneVehicle& b) {
  const bool along = a.station + a.front > b.station - b.rear && b.station + b.front > a.station - a.rear;
  return along && std::abs(a.lateral - b.lateral) < (a.width + b.width) / 2;
}

std::vector<SceneVehicle> everyone(const Traffic& traffic) {
  Scene scene = traffic.scene(Time{});
  scene.vehicles.push_back(scene.ego);
  return scene.vehicles;
}

/// What is wrong with the places of all vehicles, if anything is.
std::optional<std::string> collision(const Traffic& traffic) {
  const std::vector<SceneVehicle> all = everyone(traffic);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(all[i], all[j])) {
        return fmt::format("{} and {} overlap at {:.1f} m, lanes {} and {}", all[i].id, all[j].id,
                           all[i].station, all[i].lane, all[j].lane);
      }
    }
  }
  return {};
}

std::optional<std::string> off_lane(const Traffic& traffic, const Road& road) {
  for (const Vehicle& vehicle : traffic.vehicles()) {
    if (!road.lane_exists(vehicle.lane, vehicle.station))
      return fmt::format("{} is in lane {} at {:.1f} m", vehicle.id, vehicle.lane, vehicle.station);
    if (vehicle.lateral.changing()) continue;
    const double off =
        std::abs(vehicle.lateral.state().position - road.lane_centre(vehicle.lane, vehicle.station));
    if (off + vehicle.width / 2 > road.lane_width(vehicle.lane, vehicle.station) / 2)
      return fmt::format("{} is {:.2f} m off lane {} at {:.1f} m", vehicle.id, off, vehicle.lane,
                         vehicle.station);
    if (vehicle.head() > road.lane_end(vehicle.lane))
      return fmt::format("{} drives off the end of lane {}", vehicle.id, vehicle.lane);
  }
  return {};
}

RC_GTEST_PROP(VariedRoads, NobodyCollidesOrLeavesItsLane, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  const double density = *rc::gen::element(0.0, 4.0, 8.0, 15.0, 25.0, 40.0, 60.0);
  const double start = *rc::gen::inRange(400, 4000);
  TrafficConfig config = traffic_of(density);
  config.truck_change_every = 30;
  config.preset.lane_change_every = 15;
  config.ego.lane_change_every = 10;
  const Road road = VariedRoad::make(seed);
  Traffic traffic(road, config, start, seed);
  for (int tick = 0; tick < 16 * 50; ++tick) {
    traffic.advance(kTickSeconds);
    if (tick % 10 != 0) continue;
    const auto wrong = collision(traffic);
    if (wrong) RC_FAIL(fmt::format("tick {}: {}", tick, *wrong));
    const auto off = off_lane(traffic, road);
    if (off) RC_FAIL(fmt::format("tick {}: {}", tick, *off));
  }
}

/// Who went where while the ego car drove from `start` to `end`.
struct Passage {
  std::set<std::int64_t> entered, left, vanished;
  double seconds = 0;
  int trucks_changed = 0;
};

Passage drive_along(const TrafficConfig& config, double start, double end, std::uint64_t seed) {
  const Road road = VariedRoad::make(seed);
  Traffic traffic(road, config, start, seed);
  Passage passage;
  std::map<std::int64_t, Vehicle> before;
  for (; traffic.ego().station < end && passage.seconds < 900; passage.seconds += kTickSeconds) {
    traffic.advance(kTickSeconds);
    std::map<std::int64_t, Vehicle> now;
    for (const Vehicle& vehicle : traffic.vehicles()) {
      now.emplace(vehicle.id, vehicle);
      const auto was = before.find(vehicle.id);
      if (was == before.end() || was->second.lane == vehicle.lane) continue;
      if (was->second.lane == VariedRoad::kEntry) passage.entered.insert(vehicle.id);
      if (vehicle.lane == VariedRoad::kExit) passage.left.insert(vehicle.id);
      const bool by_ramp = std::max(vehicle.lane, was->second.lane) >= VariedRoad::kEntry;
      passage.trucks_changed += vehicle.truck && !by_ramp;
    }
    for (const auto& [id, vehicle] : before) {
      if (!now.contains(id) && vehicle.lane == VariedRoad::kExit) passage.vanished.insert(id);
    }
    before = std::move(now);
  }
  return passage;
}

TEST(VariedRoads, VehiclesComeByTheEntryAndLeaveByTheExit) {
  Passage all;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Passage passage = drive_along(traffic_of(8), 2100, 4200, seed);
    EXPECT_LT(passage.seconds, 150);
    all.entered.insert(passage.entered.begin(), passage.entered.end());
    for (const std::int64_t id : passage.left) all.left.insert(id + 1000 * static_cast<std::int64_t>(seed));
    for (const std::int64_t id : passage.vanished)
      all.vanished.insert(id + 1000 * static_cast<std::int64_t>(seed));
    EXPECT_EQ(passage.trucks_changed, 0);
  }
  EXPECT_GE(all.entered.size(), 5u);
  EXPECT_GE(all.left.size(), 3u);
  EXPECT_LE(all.vanished.size(), all.left.size());
  EXPECT_GE(all.vanished.size(), 1u);
  TrafficConfig config = traffic_of(8);
  config.entering_every = TrafficConfig::kNever;
  config.leaving = 0;
  const Passage through = drive_along(config, 2100, 4200, 1);
  EXPECT_TRUE(through.entered.empty());
  EXPECT_TRUE(through.left.empty());
}

TEST(VariedRoads, EvenInAJamEveryoneGetsOutOfALaneThatEnds) {
  for (const double density : {8.0, 30.0, 50.0}) {
    const Passage passage = drive_along(traffic_of(density), 1000, 1600, 3);
    EXPECT_LT(passage.seconds, 600) << density;
  }
}

TEST(VariedRoads, TheEgoCarLeavesALaneThatEnds) {
  const Road road = VariedRoad::make(1);
  TrafficConfig config = traffic_of(0);
  config.ego.lane_change_every = 3;  // so that it comes to the left lane
  int in_ending_lane = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Traffic traffic(road, config, 420, seed);
    bool was_in_it = false;
    while (traffic.ego().station < VariedRoad::kEndingLaneEnd + 200) {
      traffic.advance(kTickSeconds);
      was_in_it |= traffic.ego().lane == VariedRoad::kEndingLane;
      ASSERT_GT(traffic.ego().speed, 15);
      ASSERT_FALSE(off_lane(traffic, road));
    }
    in_ending_lane += was_in_it;
  }
  EXPECT_GE(in_ending_lane, 3);
}

TEST(VariedRoads, TrucksChangeLanesWhereTheSceneSaysSo) {
  TrafficConfig config = traffic_of(8);
  config.truck_change_every = 20;
  EXPECT_GT(drive_along(config, 1800, 5500, 4).trucks_changed, 0);
}

/// On shifted lanes, in a lane change and in a jam alike.
TEST(VariedRoads, SpeedAndYawRateAreTheDerivativesOfThePose) {
  for (const double density : {8.0, 50.0}) {
    const Road road = VariedRoad::make(7);
    Traffic traffic(road, traffic_of(density), 4100, 5);
    Moments speed, yaw_rate;
    for (int tick = 0; tick < 60 * 50; ++tick) {
      const SceneVehicle before = traffic.scene(Time{}).ego;
      traffic.advance(kTickSeconds);
      const SceneVehicle after = traffic.scene(Time{}).ego;
      const Pose2 step = before.world_from_vehicle.inverse() * after.world_from_vehicle;
      speed.add(step.x / kTickSeconds - (before.speed + after.speed) / 2);
      yaw_rate.add(step.heading / kTickSeconds - (before.yaw_rate + after.yaw_rate) / 2);
      ASSERT_LT(std::abs(step.y), 0.002) << "no slip";
      ASSERT_LT(std::abs(after.yaw_rate), 0.15);
    }
    EXPECT_LT(speed.rms(), 0.02);
    EXPECT_LT(yaw_rate.rms(), 3e-3);
  }
}

/// Means over time and seeds, of everyone in reach.
struct Flow {
  Moments density;  ///< [1/km] a lane
  Moments speed;    ///< [m/s]
};

Flow flow_of(const TrafficConfig& config, int seconds) {
  Flow flow;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Road road(RoadKind::gentle, 12'000, nominal_preset().road, seed);
    Traffic traffic(road, config, 400, seed);
    for (int tick = 0; tick < seconds * 50; ++tick) {
      traffic.advance(kTickSeconds);
      if (tick % 50 != 0) continue;
      flow.density.add(static_cast<double>(traffic.vehicles().size() - 1) / 0.6 / 3);
      for (const Vehicle& vehicle : traffic.vehicles()) flow.speed.add(vehicle.speed);
    }
  }
  return flow;
}

TEST(TrafficFlow, IsAsDenseAsAskedAndSlowerTheDenserItIs) {
  double last = 100;
  for (const double density : {5.0, 20.0, 30.0, 60.0}) {
    const Flow flow = flow_of(traffic_of(density), 100);
    EXPECT_NEAR(flow.density.mean(), density, 0.3 * density);
    EXPECT_LT(flow.speed.mean(), last);
    last = flow.speed.mean();
  }
  EXPECT_LT(last, 6);
  EXPECT_EQ(flow_of(traffic_of(0), 10).density.mean(), 0);
}

TEST(TrafficFlow, AJamGoesInWavesThatStopTheCars) {
  TrafficConfig config = traffic_of(40);
  config.jam_speed = 6;
  const Road road(RoadKind::gentle, 6000, nominal_preset().road, 1);
  Traffic traffic(road, config, 400, 1);
  int stops = 0;
  bool moves = true;
  Moments speed;
  for (int tick = 0; tick < 300 * 50; ++tick) {
    traffic.advance(kTickSeconds);
    const double now = traffic.ego().speed;
    speed.add(now);
    stops += moves && now < 0.3;
    moves = moves ? now >= 0.3 : now > 3;
  }
  EXPECT_GE(stops, 3);
  EXPECT_NEAR(speed.mean(), 5, 2.5);
  EXPECT_GT(speed.sigma(), 2);
}

TEST(TrafficConfig, TheEgoCarStopsAndGoes) {
  TrafficConfig config = traffic_of(0);
  config.ego_stop_and_go = StopAndGo{15, 0, 40};
  const Road road(RoadKind::gentle, 6000, nominal_preset().road, 1);
  Traffic traffic(road, config, 400, 1);
  double slowest = 100, fastest = 0;
  for (int tick = 0; tick < 120 * 50; ++tick) {
    const double station = traffic.ego().station;
    traffic.advance(kTickSeconds);
    ASSERT_GE(traffic.ego().station, station);
    if (tick < 20 * 50) continue;
    slowest = std::min(slowest, traffic.ego().speed);
    fastest = std::max(fastest, traffic.ego().speed);
  }
  EXPECT_EQ(slowest, 0);
  EXPECT_NEAR(fastest, 15, 1);
}

TEST(TrafficConfig, ATruckKeepsAheadOfTheEgoCarAndNobodyComesBetween) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    TrafficConfig config = traffic_of(15);
    config.lead_truck_gap = 30;
    config.ego.lane_change_every = TrafficConfig::kNever;
    config.preset.lane_change_every = 10;
    const Road road(RoadKind::gentle, 6000, nominal_preset().road, seed);
    Traffic traffic(road, config, 400, seed);
    for (int tick = 0; tick < 120 * 50; ++tick, traffic.advance(kTickSeconds)) {
      const Vehicle& ego = traffic.ego();
      const Vehicle& truck = traffic.vehicles()[1];
      ASSERT_TRUE(truck.truck && truck.leads_ego);
      ASSERT_EQ(truck.lane, ego.lane);
      ASSERT_GT(gap_between(ego, truck), 15);
      ASSERT_LT(gap_between(ego, truck), 80);
      for (const Vehicle& other : traffic.vehicles()) {
        const bool between = other.station > ego.station && other.station < truck.station;
        ASSERT_FALSE(between && other.occupies(ego.lane)) << "seed " << seed << " tick " << tick;
      }
      ASSERT_FALSE(tick % 25 == 0 && collision(traffic));
    }
  }
}

}  // namespace
}  // namespace lanefuse
