// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sumo_network.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "simulation/sumo_traffic.hpp"
#include "simulation/varied_road.hpp"

namespace lanefuse {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(SumoNetwork, IsTheRoadLaidStraight) {
  const Road road(RoadKind::curved, 2000, nominal_preset().road, 1);
  const std::string network = sumo_network(road);
  EXPECT_EQ(count(network, "<lane "), 3u);
  EXPECT_EQ(count(network, "<edge "), 1u);
  EXPECT_LT(network.find("road_0"), network.find("road_2"));
  const std::string right = network.substr(network.find("<lane id=\"road_0\""));
  EXPECT_NE(right.find("shape=\"0.000,-"), std::string::npos) << "the right lane comes first";
}

TEST(SumoNetwork, HoldsTheEgoCarAndAsManyVehiclesAsAsked) {
  const Road road(RoadKind::gentle, 5000, nominal_preset().road, 1);
  TrafficConfig config = nominal_traffic(nominal_preset());
  const std::string vehicles = sumo_vehicles(road, config, 400, 1);
  EXPECT_EQ(count(vehicles, "type=\"ego\""), 1u);
  EXPECT_NEAR(static_cast<double>(count(vehicles, "<vehicle ")), 3 * 8 * road.length() / 1000, 35);
  EXPECT_EQ(vehicles, sumo_vehicles(road, config, 400, 1));
  config.preset.vehicles_per_metre_lane = 0;
  EXPECT_EQ(count(sumo_vehicles(road, config, 400, 1), "<vehicle "), 1u);
}

TEST(SumoNetwork, RefusesWhatSumoCannotDo) {
  EXPECT_THROW(sumo_network(testing::VariedRoad::make(1)), Error);
  const Road road(RoadKind::gentle, 1000, nominal_preset().road, 1);
  TrafficConfig config = nominal_traffic(nominal_preset());
  config.lead_truck_gap = 30;
  EXPECT_THROW(sumo_vehicles(road, config, 400, 1), Error);
}

/// Built in or not, what it says must be true.
TEST(SumoTraffic, DrivesOrSaysThatItIsNotBuiltIn) {
  const Road road(RoadKind::gentle, 2000, nominal_preset().road, 1);
  std::unique_ptr<TrafficModel> traffic;
  try {
    traffic = sumo_traffic(road, nominal_traffic(nominal_preset()), 400, 1);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::configuration);
    EXPECT_NE(std::string(error.what()).find("LANEFUSE_SUMO"), std::string::npos);
    return;
  }
  const double before = traffic->scene(Time{}).ego.station;
  for (int tick = 0; tick < 10 * 50; ++tick) traffic->advance(0.02);
  EXPECT_NEAR(traffic->scene(Time{}).ego.station - before, 10 * 28, 40);
}

}  // namespace
}  // namespace lanefuse
