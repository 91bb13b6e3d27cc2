// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/fault_votes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kStands = 1;     ///< [m/s] over ground at most, as a radar's range rates tell
constexpr double kMoves = 3;      ///< [m/s] over ground at least
constexpr double kKmhOfMs = 3.6;  ///< [km/h] a metre a second

Eigen::Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// [m/s] The range rate of what stands in the direction of this bearing.
double standing_rate(const SightingSet& look, double bearing) {
  return -look.velocity.dot(direction(look.odometry_from_sensor.heading + bearing));
}

bool stands(const SightingSet& look, const Sighting& sighting) {
  const auto speed = ground_speed(look, sighting);
  return speed && std::abs(*speed) < kMoves;
}

/// Where something seen elsewhere would be in a look.
struct Place {
  double range = 0;
  double bearing = 0;
  double range_gate = 0;  ///< [m]
  double gate = 0;        ///< [m] across the line of sight
};

bool sees(const SightingSet& look, const Place& place, double bearing) {
  return std::any_of(look.sightings.begin(), look.sightings.end(), [&](const Sighting& sighting) {
    return !stands(look, sighting) && std::abs(sighting.bearing - bearing) * place.range < place.gate &&
           std::abs(sighting.range - place.range) < place.range_gate + 2 * sighting.range_sigma;
  });
}

}  // namespace

std::optional<double> ground_speed(const SightingSet& look, const Sighting& sighting) {
  if (!sighting.range_rate) return {};
  return *sighting.range_rate - standing_rate(look, sighting.bearing);
}

void vote_on_field(const SightingSet& look, std::size_t turned_beyond, FaultVotes& votes) {
  constexpr double kLargerBy = 1.5;  // than the field is known to be
  constexpr double kMargin = 10 * kDegree;
  constexpr double kWeight = 3;  // no sound sensor sees there at all
  const double widest =
      std::max(look.field.half_angle, look.field.near_range > 0 ? look.field.near_half_angle : 0);
  votes.wrong += kWeight * static_cast<double>(turned_beyond);
  for (const Sighting& sighting : look.sightings) {
    const bool beyond = std::abs(sighting.bearing) > kLargerBy * widest + kMargin;
    beyond ? votes.wrong += kWeight : votes.sound += 1;
  }
}

void vote_on_standing(const SightingSet& look, FaultVotes& votes) {
  // Slower, what looks like standing in km/h may as well be a fast vehicle that comes towards us.
  constexpr double kFastEnough = 18;  // [m/s]
  for (const Sighting& sighting : look.sightings) {
    const double expected = standing_rate(look, sighting.bearing);
    if (!sighting.range_rate || expected > -kFastEnough) continue;
    if (std::abs(*sighting.range_rate - expected) < kStands) votes.sound += 1;
    if (std::abs(*sighting.range_rate / kKmhOfMs - expected) < kStands) votes.wrong += 1;
  }
}

/// A vehicle may by chance look like a standing thing in the mirror: only several in one look count.
void vote_on_standing_mirror(const SightingSet& look, FaultVotes& votes) {
  constexpr double kApart = 4;  // [m/s]
  constexpr int kSeveral = 3;
  int as_said = 0;
  int mirrored = 0;
  for (const Sighting& sighting : look.sightings) {
    const double expected = standing_rate(look, sighting.bearing);
    const double elsewhere = standing_rate(look, -sighting.bearing);
    if (!sighting.range_rate || std::abs(expected - elsewhere) < kApart) continue;
    // Whatever keeps pace with us looks like a thing abeam.
    if (std::abs(expected) < kApart || std::abs(elsewhere) < kApart) continue;
    if (std::abs(*sighting.range_rate - expected) < kStands) ++as_said;
    if (std::abs(*sighting.range_rate - elsewhere) < kStands) ++mirrored;
  }
  if (as_said > 0) votes.sound += 1;
  if (mirrored >= kSeveral && mirrored > 2 * as_said) votes.wrong += 1;
}

void vote_on_mirror(const SightingSet& look, const SightingSet& other, FaultVotes& votes) {
  constexpr double kInner = 0.85;        // of the field: at its edge things may be missed
  constexpr double kAcross = 1.3;        // [m] that a vehicle's seen points lie apart
  constexpr double kAlong = 4;           // [m]
  constexpr double kApart = 0.75;        // of the gates' width, that the axis is away at least
  constexpr double kFurtherApart = 0.5;  // [m] and more
  const Pose2 look_from_other = look.odometry_from_sensor.inverse() * other.odometry_from_sensor;
  for (const Sighting& seen : other.sightings) {
    if (stands(other, seen)) continue;
    const Eigen::Vector2d at = look_from_other * Eigen::Vector2d(seen.range * direction(seen.bearing));
    Place place{at.norm(), std::atan2(at.y(), at.x()), kAlong + 2 * seen.range_sigma, kAcross};
    if (!look.field.contains(place.range / kInner, place.bearing / kInner)) continue;
    const double own_sigma = look.sightings.empty() ? 0 : look.sightings.front().bearing_sigma;
    place.gate += 2 * (seen.bearing_sigma * seen.range + own_sigma * place.range);
    if (std::abs(at.y()) < kApart * place.gate + kFurtherApart) continue;
    const bool as_said = sees(look, place, place.bearing);
    const bool mirrored = sees(look, place, -place.bearing);
    if (as_said && !mirrored) votes.sound += 1;
    if (mirrored && !as_said) votes.wrong += 1;
  }
}

std::optional<double> turn_by_range_rate(const SightingSet& look, const Sighting& sighting) {
  constexpr double kFirst = 25 * kDegree;  // of the way: there, a degree changes the range rate by 0.7 %
  constexpr double kLast = 65 * kDegree;
  const double speed = look.velocity.norm();
  const double course = std::atan2(look.velocity.y(), look.velocity.x());
  const double said = wrap_angle(look.odometry_from_sensor.heading + sighting.bearing - course);
  const double cosine = -sighting.range_rate.value_or(0) / std::max(speed, 1.0);
  if (!sighting.range_rate || !(std::abs(cosine) < 1)) return {};
  const double truly = std::copysign(std::acos(cosine), said);
  // Behind the car things go away as they came.
  const double aside = std::min(std::abs(truly), std::numbers::pi - std::abs(truly));
  if (aside < kFirst || aside > kLast) return {};
  const double turn = said - truly;
  if (std::abs(turn) > BearingOffsets::kReach * kDegree) return {};
  return turn;
}

void compare_bearings(const SightingSet& look, const SightingSet& other, BearingOffsets& offsets) {
  constexpr double kNearest = 12;                             // [m]: nearer, vehicles are wide
  constexpr double kAlong = 4;                                // [m]
  constexpr double kClear = 1.2 * kDegree;                    // of both bearings together
  constexpr double kEdge = BearingOffsets::kReach * kDegree;  // what is turned away is not seen any more
  const Pose2 look_from_other = look.odometry_from_sensor.inverse() * other.odometry_from_sensor;
  for (const Sighting& seen : other.sightings) {
    if (stands(other, seen)) continue;
    const Eigen::Vector2d at = look_from_other * Eigen::Vector2d(seen.range * direction(seen.bearing));
    const double range = at.norm();
    const double bearing = std::atan2(at.y(), at.x());
    if (range < kNearest || !look.field.contains(range, bearing)) continue;
    for (const Sighting& own : look.sightings) {
      if (stands(look, own) || std::hypot(own.bearing_sigma, seen.bearing_sigma) > kClear) continue;
      if (std::abs(own.range - range) > kAlong + 2 * std::hypot(seen.range_sigma, own.range_sigma)) continue;
      if (std::abs(own.bearing - bearing) < kEdge) offsets.add(own.bearing - bearing);
    }
  }
}

bool should_see(const SightingSet& look, const SightingSet& other) {
  constexpr double kInner = 0.55;  // of the field, along and across
  constexpr double kNearest = 12;  // [m]: nearer, it may be beside the field
  constexpr double kBeside = 5;    // [m] of the car's way: beyond it, ghosts live behind rails
  const Pose2 look_from_other = look.odometry_from_sensor.inverse() * other.odometry_from_sensor;
  const Pose2 vehicle_from_other = look.odometry_from_vehicle.inverse() * other.odometry_from_sensor;
  return std::any_of(other.sightings.begin(), other.sightings.end(), [&](const Sighting& seen) {
    const Eigen::Vector2d place = seen.range * direction(seen.bearing);
    const Eigen::Vector2d at = look_from_other * place;
    const double beside = std::abs((vehicle_from_other * place).y());
    const double bearing = std::atan2(at.y(), at.x());
    return !stands(other, seen) && at.norm() > kNearest && beside < kBeside &&
           look.field.contains(at.norm() / kInner, bearing / kInner);
  });
}

}  // namespace lanefuse
