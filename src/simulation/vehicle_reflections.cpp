// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle_reflections.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kWander = 0.3;                  ///< [half widths] sigma of the centre
constexpr double kWanderTau = 1;                 ///< [s]
constexpr double kScatter = 0.3;                 ///< [half widths] sigma about the centre
constexpr Duration kForgetAfter{5'000'000'000};  ///< unseen for so long, a vehicle gets a new centre
constexpr double kWheel = 0.25;                  ///< share of a side's reflections
constexpr double kCorner = 0.15;                 ///< share of a side's reflections
constexpr double kAxle = 0.18;                   ///< of the length, from either end to the axle

/// How large a face looks: its length times the cosine of the angle at which it is seen. `ahead` [m] of the
/// face stands the radar, `beside` [m] the face's middle.
double looks(double length, double ahead, double beside) {
  return ahead > 0 ? length * ahead / std::hypot(ahead, beside) : 0;
}

}  // namespace

double VehicleReflections::across(const SceneVehicle& vehicle, Time now) {
  std::erase_if(centres_, [now](const auto& entry) { return now - entry.second.seen > kForgetAfter; });
  auto found = centres_.find(vehicle.id);
  if (found == centres_.end()) {
    found = centres_.emplace(vehicle.id, Centre{Wander(kWander, kWanderTau, random_), now}).first;
  }
  Centre& centre = found->second;
  if (centre.seen < now) centre.wander.advance(to_seconds(now - centre.seen), random_);
  centre.seen = now;
  return std::clamp(centre.wander.value() + random_.normal(kScatter), -1.0, 1.0) * vehicle.width / 2;
}

Eigen::Vector2d VehicleReflections::on_side(const SceneVehicle& vehicle, const Eigen::Vector2d& radar) {
  const double length = vehicle.front + vehicle.rear;
  const double y = std::copysign(vehicle.width / 2, radar.y());
  const double kind = random_.uniform();
  const double along = random_.uniform();
  if (kind < kWheel) return {-vehicle.rear + length * (along < 0.5 ? kAxle : 1 - kAxle), y};
  if (kind < kWheel + kCorner)
    return {radar.x() < (vehicle.front - vehicle.rear) / 2 ? -vehicle.rear : vehicle.front, y};
  return {-vehicle.rear + length * along, y};
}

Reflection VehicleReflections::draw(const SceneVehicle& vehicle, const Eigen::Vector2d& radar, Time now) {
  const Eigen::Vector2d from = vehicle.world_from_vehicle.inverse() * radar;
  const bool behind = from.x() < -vehicle.rear;
  const double ahead = behind ? -vehicle.rear - from.x() : from.x() - vehicle.front;
  const double end = looks(vehicle.width, ahead, from.y());
  const double side = looks(vehicle.front + vehicle.rear, std::abs(from.y()) - vehicle.width / 2,
                            from.x() - (vehicle.front - vehicle.rear) / 2);
  const bool is_on_side = random_.uniform() * (end + side) < side;
  const Eigen::Vector2d point =
      is_on_side ? on_side(vehicle, from)
                 : Eigen::Vector2d(behind ? -vehicle.rear : vehicle.front, across(vehicle, now));
  const Eigen::Vector2d in_world = vehicle.world_from_vehicle * point;
  return {in_world, velocity_of(vehicle, in_world)};
}

}  // namespace lanefuse
