// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sumo_network.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "simulation/traffic_flow.hpp"

namespace lanefuse {
namespace {

constexpr double kSpeedLimit = 36;      ///< [m/s]
constexpr double kClearOfEgo = 40;      ///< [m]
constexpr double kLongestVehicle = 16;  ///< [m]

void check_straightness(const Road& road) {
  for (int lane = 0; lane < road.lane_count(); ++lane) {
    const bool whole = road.lane_begin(lane) <= 1 && road.lane_end(lane) >= road.length() - 1;
    for (double station = 0; station <= road.length(); station += 50) {
      if (whole && std::abs(road.lane_centre_slope(lane, station)) < 1e-9) continue;
      throw configuration_error("--traffic sumo",
                                fmt::format("lane {} begins, ends or moves near {:.0f} m", lane, station),
                                "use the built-in traffic on such a road");
    }
  }
}

/// SUMO counts its lanes from the right.
std::string lane_element(const Road& road, int lane) {
  const int index = road.lane_count() - 1 - lane;
  const double y = road.lane_centre(lane, 0);
  return fmt::format(
      "<lane id=\"road_{0}\" index=\"{0}\" speed=\"{1}\" length=\"{2:.3f}\" width=\"{3:.3f}\" "
      "shape=\"0.000,{4:.3f} {2:.3f},{4:.3f}\"/>\n",
      index, kSpeedLimit, road.length(), road.lane_width(lane, 0), y);
}

constexpr const char* kTypes =
    "<vType id=\"car\" length=\"4.5\" width=\"1.8\" maxSpeed=\"45\" "
    "speedFactor=\"normc(0.85,0.07,0.65,1.1)\" "
    "lcSigma=\"0.2\" maxSpeedLat=\"1.5\" minGapLat=\"0.6\"/>\n"
    "<vType id=\"truck\" vClass=\"truck\" length=\"13\" width=\"2.5\" maxSpeed=\"24.5\" accel=\"0.7\" "
    "lcSigma=\"0.2\" "
    "maxSpeedLat=\"1\" minGapLat=\"0.6\"/>\n";

void check_wishes(const TrafficConfig& config) {
  const char* wish = config.jam_speed         ? "a jam of a given speed"
                     : config.lead_truck_gap  ? "a truck ahead of the ego car"
                     : config.ego_stop_and_go ? "an ego car that stops and goes"
                                              : nullptr;
  if (wish) {
    throw configuration_error("--traffic sumo", fmt::format("SUMO's drivers do not know {}", wish),
                              "use the built-in traffic for such a scenario");
  }
}

std::string vehicle_element(std::int64_t id, const char* type, int lane, double station) {
  return fmt::format(
      "<vehicle id=\"{}\" type=\"{}\" route=\"road\" depart=\"0\" departLane=\"{}\" departPos=\"{:.2f}\" "
      "departSpeed=\"{}\"/>\n",
      id, type, lane, station, "desired");
}

}  // namespace

std::string sumo_network(const Road& road) {
  check_straightness(road);
  std::string lanes, ids;
  for (int lane = road.lane_count() - 1; lane >= 0; --lane) {
    lanes += lane_element(road, lane);
    ids += fmt::format("{}road_{}", ids.empty() ? "" : " ", road.lane_count() - 1 - lane);
  }
  const double end = road.length();
  return fmt::format(
      "<net version=\"1.9\">\n"
      "<location netOffset=\"0,0\" convBoundary=\"0,-50,{0:.3f},50\" origBoundary=\"0,-50,{0:.3f},50\" "
      "projParameter=\"!\"/>\n"
      "<edge id=\"road\" from=\"a\" to=\"b\" priority=\"1\">\n{1}</edge>\n"
      "<junction id=\"a\" type=\"dead_end\" x=\"0\" y=\"0\" incLanes=\"\" intLanes=\"\" shape=\"0,0\"/>\n"
      "<junction id=\"b\" type=\"dead_end\" x=\"{0:.3f}\" y=\"0\" incLanes=\"{2}\" intLanes=\"\" "
      "shape=\"{0:.3f},0\"/>\n"
      "</net>\n",
      end, lanes, ids);
}

std::string sumo_vehicles(const Road& road, const TrafficConfig& config, double start, std::uint64_t seed) {
  check_wishes(config);
  const auto from_right = [&road](int lane) { return road.lane_count() - 1 - lane; };
  Random random(seed, "sumo");
  const TrafficFlow flow(config);
  const std::string ego_type = fmt::format(
      "<vType id=\"ego\" length=\"4.8\" width=\"1.85\" maxSpeed=\"{}\" speedFactor=\"1\" speedDev=\"0\" "
      "lcSigma=\"0.2\" "
      "maxSpeedLat=\"1.5\" minGapLat=\"0.6\"/>\n",
      config.ego.speed);
  const int ego_lane = config.ego_lane.value_or(road.lane_count() / 2);
  std::string text = fmt::format("<routes>\n{}{}<route id=\"road\" edges=\"road\"/>\n", kTypes, ego_type);
  text += vehicle_element(0, "ego", from_right(ego_lane), start);
  std::int64_t id = 1;
  for (int lane = 0; lane < road.lane_count(); ++lane) {
    double station = flow.draw_headway(random);
    for (; station < road.length(); station += std::max(kLongestVehicle + 3, flow.draw_headway(random))) {
      const bool truck = from_right(lane) == 0 && random.chance(config.preset.trucks * road.lane_count());
      if (lane == ego_lane && std::abs(station - start) < kClearOfEgo) continue;
      text += vehicle_element(id++, truck ? "truck" : "car", from_right(lane), station);
    }
  }
  return text + "</routes>\n";
}

}  // namespace lanefuse
