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

}  // namespace lanefuse
