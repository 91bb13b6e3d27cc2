// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/lane_changes.hpp"

#include "simulation/traffic_flow.hpp"

namespace lanefuse {
namespace {

constexpr double kExitPace = 22;    ///< [m/s] on an exit lane
constexpr double kLeastExit = 160;  ///< [m] of an exit lane that must be left for it to be taken

/// Nobody comes between the ego car and the truck it follows.
bool would_part_ego_from_lead(const Vehicle& vehicle, int lane, const std::vector<Vehicle>& all) {
  const Vehicle& ego = all.front();
  if (vehicle.id == kEgoId || !ego.occupies(lane) || vehicle.head() < ego.tail()) return false;
  for (const Vehicle& other : all) {
    if (other.leads_ego && other.occupies(lane) && vehicle.tail() < other.head()) return true;
  }
  return false;
}

}  // namespace

void LaneChanges::consider(Vehicle& vehicle, const std::vector<Vehicle>& all, double seconds) {
  vehicle.wait -= seconds;
  if (vehicle.lateral.changing()) return;
  vehicle.must_enter = forced(vehicle);
  if (!vehicle.must_enter) {
    if (vehicle.wait <= 0 && lanes_.is_driving(vehicle.lane)) consider_wish(vehicle, all);
  } else if (is_free_for(vehicle, *vehicle.must_enter, all)) {
    begin(vehicle, *vehicle.must_enter);
  }
}

std::optional<int> LaneChanges::forced(Vehicle& vehicle) {
  const bool drives_out = lanes_.is_exit(vehicle.lane) && vehicle.leaving;
  if (drives_out) return {};
  const std::optional<int> out = out_of_ending(vehicle);
  return out ? out : to_exit(vehicle);
}

/// To the side where the road goes on; else to the lane beside that lasts longest.
std::optional<int> LaneChanges::out_of_ending(const Vehicle& vehicle) const {
  const double end = lanes_.end(vehicle.lane);
  if (vehicle.head() + TrafficLanes::kNotice < end) return {};
  std::optional<int> best;
  for (const int side : {1, -1}) {
    const std::optional<int> beside = lanes_.beside(vehicle.lane, side, vehicle.station);
    if (beside && !lanes_.is_exit(*beside) && lanes_.end(*beside) > (best ? lanes_.end(*best) : end))
      best = beside;
  }
  return best;
}

std::optional<int> LaneChanges::to_exit(Vehicle& vehicle) {
  const std::optional<int> exit = lanes_.beside(vehicle.lane, -1, vehicle.station);
  if (!exit || !lanes_.is_exit(*exit) || vehicle.id == kEgoId || vehicle.leads_ego) return {};
  if (vehicle.exit_seen != exit) vehicle.leaving = random_.chance(config_.leaving);
  vehicle.exit_seen = exit;
  if (vehicle.head() + kLeastExit > lanes_.end(*exit)) vehicle.leaving = false;
  return vehicle.leaving ? exit : std::nullopt;
}

void LaneChanges::consider_wish(Vehicle& vehicle, const std::vector<Vehicle>& all) {
  if (vehicle.wish == 0) vehicle.wish = draw_wish(vehicle);
  const std::optional<int> lane = lanes_.through_beside(vehicle.lane, vehicle.wish, vehicle.station);
  if (!lane) {
    wait_anew(vehicle);
  } else if (is_free_for(vehicle, *lane, all) && !would_part_ego_from_lead(vehicle, *lane, all)) {
    begin(vehicle, *lane);
    wait_anew(vehicle);
  }
}

/// To the left (+1) or right (-1). Trucks go back to the right lane when they have left it. Only the ego car
/// insists on a lane that exists; the others' wishes for one that does not come to nothing, so that the outer
/// lanes lose no more vehicles than they gain.
int LaneChanges::draw_wish(const Vehicle& vehicle) {
  const auto has_lane = [&](int wish) {
    return lanes_.through_beside(vehicle.lane, wish, vehicle.station).has_value();
  };
  if (vehicle.truck) return has_lane(-1) ? -1 : 1;
  const int wish = random_.chance(0.5) ? 1 : -1;
  return vehicle.id == kEgoId && !has_lane(wish) ? -wish : wish;
}

void LaneChanges::wait_anew(Vehicle& vehicle) {
  vehicle.wish = 0;
  vehicle.wait = vehicle.id == kEgoId ? vehicle.wait + config_.ego.lane_change_every
                                      : draws_.wait(vehicle.truck, vehicle.station);
}

void LaneChanges::begin(Vehicle& vehicle, int lane) {
  vehicle.lane = lane;
  vehicle.must_enter.reset();
  vehicle.lateral.change_to(lanes_.centre(lane, {vehicle.station}));
  if (vehicle.id == kEgoId || vehicle.truck) return;
  const double usual =
      lanes_.is_exit(lane) ? kExitPace : usual_speed(lanes_.count_right_of(lane, vehicle.station));
  vehicle.driver.wished_speed = usual + vehicle.pace;
}

}  // namespace lanefuse
