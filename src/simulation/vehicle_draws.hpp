// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/traffic_config.hpp"
#include "simulation/traffic_lanes.hpp"
#include "simulation/traffic_model.hpp"
#include "simulation/vehicle.hpp"

namespace lanefuse {

/// Draws vehicles and their drivers.
class VehicleDraws {
 public:
  VehicleDraws(const TrafficLanes& lanes, const TrafficConfig& config, Random& random)
      : lanes_(lanes), config_(config), random_(random) {}

  Vehicle ego(double station);
  /// A truck that the ego car follows.
  Vehicle lead_truck(const Vehicle& ego);
  /// In the lane's middle, as fast as it wishes to be.
  Vehicle other(int lane, double station);
  /// For a vehicle that was drawn last and never came: its id is free again.
  void take_back() { --next_id_; }

  /// [s] until this driver wishes for another lane.
  double wait(bool truck, double station);

 private:
  const TrafficLanes& lanes_;
  const TrafficConfig& config_;
  Random& random_;
  std::int64_t next_id_ = kEgoId + 1;

  Vehicle place(int lane, double station, double width, double bias);
  void make_truck(Vehicle& vehicle, double length);
};

}  // namespace lanefuse
