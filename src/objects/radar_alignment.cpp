// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/radar_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/pose2.hpp"
#include "objects/fault_votes.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSlowest = 8;  ///< [m/s] of the own car: slower, it turns tightly and slips
constexpr double kTightest =
    0.002;                       ///< [1/m] of its way: in bends a car's front does not move straight ahead
constexpr double kStands = 1;    ///< [m/s] over ground at most
constexpr double kNearest = 15;  ///< [m]: nearer, it matters where on the thing the reflection is
constexpr std::size_t kMostThings = 64;

void follow(const SightingSet& look, const Sighting& sighting, std::vector<PassedThing>& things) {
  const auto fits = [&](const PassedThing& thing) { return thing.fits(look, sighting); };
  const auto known = std::ranges::find_if(things, fits);
  if (known == things.end()) {
    if (things.size() < kMostThings) things.emplace_back(look, sighting);
    return;
  }
  // Which of several it is, nobody knows.
  if (std::any_of(known + 1, things.end(), fits)) return;
  known->add(look, sighting);
}

}  // namespace

void RadarAlignment::look(const SightingSet& look) {
  if (!config_.enabled || look.kind != SightingKind::radar) return;
  Radar& radar = radar_of(look);
  if (look.measured_at <= radar.last_look) return;
  pass_time(radar, look);
  if (look.velocity.norm() < kSlowest || std::abs(look.own_curvature) > kTightest) return;
  for (const Sighting& sighting : look.sightings) {
    const auto speed = ground_speed(look, sighting);
    if (speed && std::abs(*speed) < kStands && sighting.range > kNearest) {
      follow(look, sighting, radar.things);
    }
  }
}

RadarAlignment::Radar& RadarAlignment::radar_of(const SightingSet& look) {
  const auto known = std::ranges::find(radars_, look.sensor_id, &Radar::id);
  if (known != radars_.end()) return *known;
  Radar& radar = radars_.emplace_back();
  radar.id = look.sensor_id;
  radar.last_look = look.measured_at - Duration(1);
  const Eigen::Vector2d sigma(config_.sigma_deg * kDegree, config_.yaw_rate_sigma_deg * kDegree);
  radar.turn.covariance = sigma.cwiseAbs2().asDiagonal();
  radar.things.reserve(kMostThings);
  return radar;
}

void RadarAlignment::pass_time(Radar& radar, const SightingSet& look) const {
  const double seconds = to_seconds(look.measured_at - radar.last_look);
  radar.last_look = look.measured_at;
  const Eigen::Vector2d sigma(config_.sigma_deg * kDegree, config_.yaw_rate_sigma_deg * kDegree);
  const Eigen::Vector2d drift(config_.drift_deg * kDegree, config_.yaw_rate_drift_deg * kDegree);
  // Never less is known than before anything was.
  for (int i = 0; i < kRadarTurnSize; ++i) {
    double& variance = radar.turn.covariance(i, i);
    variance = std::min(variance + seconds * drift[i] * drift[i], std::max(variance, sigma[i] * sigma[i]));
  }
  std::erase_if(radar.things, [&](const PassedThing& thing) {
    const bool over = thing.is_over(look);
    if (over) thing.tell(radar.turn);
    return over;
  });
}

void RadarAlignment::correct(SightingSet& look) const {
  if (look.kind != SightingKind::radar) return;
  const double turn = offset_of(look.sensor_id).value;
  for (Sighting& sighting : look.sightings) sighting.bearing = wrap_angle(sighting.bearing - turn);
}

RadarAlignment::Offset RadarAlignment::offset_of(std::uint32_t sensor_id) const {
  const auto known = std::ranges::find(radars_, sensor_id, &Radar::id);
  if (known == radars_.end()) return {0, config_.sigma_deg * kDegree};
  const double most = config_.most_deg * kDegree;
  return {std::clamp(known->turn.mean[kTurn], -most, most), std::sqrt(known->turn.covariance(kTurn, kTurn))};
}

void RadarAlignment::lose_things() {
  for (Radar& radar : radars_) radar.things.clear();
}

}  // namespace lanefuse
