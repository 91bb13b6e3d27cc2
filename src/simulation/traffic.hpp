// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "simulation/lane_changes.hpp"
#include "simulation/traffic_config.hpp"
#include "simulation/traffic_flow.hpp"
#include "simulation/traffic_lanes.hpp"
#include "simulation/traffic_model.hpp"
#include "simulation/vehicle.hpp"
#include "simulation/vehicle_draws.hpp"

namespace lanefuse {

/// The built-in drivers: the ego car and the vehicles within kTrafficReach of it.
///
/// Each lane has its usual speed; trucks keep to the right lane. Drivers follow their leader, wander in their
/// lane and change it when they have waited long enough and find a gap, leave a lane that ends, let others
/// in, and take an exit. Vehicles enter at the ends of the reach as if the traffic went on there, and on
/// entry lanes; they are forgotten beyond the reach and at the end of exit lanes. No vehicle ever runs into
/// another.
class Traffic final : public TrafficModel {
 public:
  /// The ego car starts in the middle lane at `start` [m]. The road must outlive the traffic.
  Traffic(const Road& road, const TrafficConfig& config, double start, std::uint64_t seed);
  Traffic(const Traffic&) = delete;
  Traffic& operator=(const Traffic&) = delete;

  void advance(double seconds) override;
  [[nodiscard]] Scene scene(Time time) const override;

  [[nodiscard]] const Vehicle& ego() const { return vehicles_.front(); }
  /// The ego car first, the others in the order of their coming.
  [[nodiscard]] const std::vector<Vehicle>& vehicles() const { return vehicles_; }

 private:
  TrafficConfig config_;
  TrafficLanes lanes_;
  TrafficFlow flow_;
  Random random_;
  VehicleDraws draws_;
  LaneChanges changes_;
  double time_ = 0;  ///< [s] since the start
  std::vector<Vehicle> vehicles_;
  struct Headways {
    double front;  ///< [m] from the foremost vehicle to the next that enters
    double rear;   ///< [m] from the rearmost one
  };
  std::vector<Headways> headways_;  ///< a lane

  [[nodiscard]] double limit_at(double station) const { return flow_.speed_limit(station, time_); }
  [[nodiscard]] bool keeps_clear_of_ego(int lane, double station) const;
  void fill(int lane);
  void steer_ego();
  void forget();
  void enter(int lane);
  void enter_at(int lane, double station, bool ahead);
  void enter_from_ramp(int lane, double seconds);
  [[nodiscard]] bool fits(const Vehicle& newcomer) const;
};

inline constexpr double kTrafficReach = 300;  ///< [m] ahead of and behind the ego car

}  // namespace lanefuse
