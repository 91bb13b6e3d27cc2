// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/right_of_way.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kLeastGap = 10;         ///< [m] for a lane change, in front and behind; less in slow traffic
constexpr double kPoliteBraking = -3;    ///< [m/s^2] asked of anyone by a lane change
constexpr double kYielding = -2;         ///< [m/s^2] at most, to let someone in
constexpr double kRoomToLetIn = 1;       ///< [m] ahead, else it is too late to let someone in
constexpr double kStopBefore = 15;       ///< [m] from a lane's end to the bumper of who waits there
constexpr double kStoppingBrakes = 2.5;  ///< [m/s^2] towards a lane's end
constexpr double kFullBraking = -8;      ///< [m/s^2]

double least_gap(double speed) { return std::min(kLeastGap, 3 + 0.6 * speed); }

/// None as long as less than kStoppingBrakes would do; then as much as it needs.
double before_lane_end(const Vehicle& vehicle, const TrafficLanes& lanes) {
  const bool drives_out = lanes.is_exit(vehicle.lane) && vehicle.leaving;
  const double left = lanes.end(vehicle.lane) - kStopBefore - vehicle.head();
  if (drives_out || left == INFINITY) return INFINITY;
  if (left < 0.5) return kFullBraking;
  const double needed = vehicle.speed * vehicle.speed / (2 * left);
  return needed < kStoppingBrakes ? INFINITY : std::max(kFullBraking, -needed);
}

/// Between one who wants into a lane and one who is in it, the one goes first whose head is ahead, if there
/// is still room for it; otherwise the one in the lane.
bool lets_in(const Vehicle& owner, const Vehicle& newcomer) {
  return newcomer.must_enter == owner.lane && gap_between(owner, newcomer) > kRoomToLetIn;
}

bool waits_for(const Vehicle& newcomer, const Vehicle& owner) {
  return newcomer.must_enter && owner.occupies(*newcomer.must_enter) && !lets_in(owner, newcomer) &&
         owner.head() > newcomer.tail();
}

}  // namespace

double acceleration_among(const Vehicle& vehicle, const std::vector<Vehicle>& all, const TrafficLanes& lanes,
                          const FlowAhead& flow) {
  CarFollowing driver = vehicle.driver;
  driver.wished_speed = std::min(driver.wished_speed, flow.speed_limit);
  bool leads = true;
  double acceleration = std::min(driver.free(vehicle.speed), before_lane_end(vehicle, lanes));
  for (const Vehicle& other : all) {
    if (&other == &vehicle) continue;
    const bool ahead = other.station + other.front > vehicle.head();
    const bool in_the_way = other.occupies(vehicle.lane) || other.occupies(vehicle.left_behind);
    const auto behind = [&] {
      return driver.behind(vehicle.speed, gap_between(vehicle, other), other.speed);
    };
    if (in_the_way && ahead) {
      leads = false;
      acceleration = std::min(acceleration, behind());
    } else if (lets_in(vehicle, other) || waits_for(vehicle, other)) {
      acceleration = std::min(acceleration, std::max(kYielding, behind()));
    }
  }
  if (leads && flow.gap < INFINITY)
    acceleration = std::min(acceleration, driver.behind(vehicle.speed, flow.gap, vehicle.speed));
  return acceleration;
}

bool in_safe_order(const Vehicle& follower, const Vehicle& leader) {
  const double gap = gap_between(follower, leader);
  return gap >= least_gap(follower.speed) &&
         follower.driver.behind(follower.speed, gap, leader.speed) >= kPoliteBraking;
}

bool is_free_for(const Vehicle& vehicle, int lane, const std::vector<Vehicle>& all) {
  return std::none_of(all.begin(), all.end(), [&](const Vehicle& other) {
    if (other.id == vehicle.id || !other.occupies(lane)) return false;
    const bool other_leads = other.head() > vehicle.head();
    return other_leads ? !in_safe_order(vehicle, other) : !in_safe_order(other, vehicle);
  });
}

}  // namespace lanefuse
