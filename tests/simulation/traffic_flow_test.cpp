// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/traffic_flow.hpp"

#include <gtest/gtest.h>

#include "simulation/scene_run.hpp"
#include "simulation/traffic.hpp"

namespace lanefuse {
namespace {

using testing::Moments;

constexpr double kTickSeconds = 0.02;

TrafficConfig traffic_of(double vehicles_per_km_lane) {
  TrafficConfig config = nominal_traffic(nominal_preset());
  config.preset.vehicles_per_metre_lane = vehicles_per_km_lane / 1000;
  return config;
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

}  // namespace
}  // namespace lanefuse
