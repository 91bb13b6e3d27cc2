// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/standing_things.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSlowest = 8;      ///< [m/s] of the own car: slower, it turns tightly and slips
constexpr double kTightest = 0.01;  ///< [1/m]
constexpr double kStands = 1;       ///< [m/s] over ground at most
constexpr double kNearest = 8;      ///< [m]: nearer, it matters where on the thing the reflection is
constexpr double kWander = 0.3;     ///< [m] of a reflection on its thing
constexpr double kRangeGate = 1;    ///< [m] about where it should be
constexpr double kMostTurn = 12;    ///< [deg] of the mounting that is looked for
constexpr double kShortest = 0.6;   ///< [s] between two looks that are compared
constexpr double kLongest = 2;      ///< [s] for which a thing is remembered
constexpr std::size_t kMostThings = 64;

Eigen::Vector2d polar(double range, double bearing) {
  return {range * std::cos(bearing), range * std::sin(bearing)};
}

double bearing_of(const Eigen::Vector2d& place) { return std::atan2(place.y(), place.x()); }

/// Where what stood at this bearing is to be seen now.
Eigen::Vector2d seen_now(const Pose2& now_from_then, double range, double bearing) {
  return now_from_then * polar(range, bearing);
}

/// What the two readings of one thing's first bearing make of it now.
struct Readings {
  double as_said = 0;    ///< [rad]
  double mirrored = 0;   ///< [rad] as the sensor would say it
  double spreading = 0;  ///< [rad/rad] by how much bearings change for each that they began with
};

Readings readings(const Pose2& now_from_then, const Sighting& then) {
  constexpr double kStep = 0.01;  // [rad]
  const auto at = [&](double bearing) { return seen_now(now_from_then, then.range, bearing); };
  const Eigen::Vector2d place = at(then.bearing);
  const double spread =
      wrap_angle(bearing_of(at(then.bearing + kStep)) - bearing_of(at(then.bearing - kStep))) / (2 * kStep);
  return {bearing_of(place), -bearing_of(at(-then.bearing)), spread};
}

}  // namespace

void StandingThings::look(const SightingSet& look) {
  std::erase_if(things_,
                [&](const Thing& thing) { return to_seconds(look.measured_at - thing.seen_at) > kLongest; });
  if (look.velocity.norm() < kSlowest || std::abs(look.own_curvature) > kTightest) return;
  fresh_.clear();
  for (const Sighting& sighting : look.sightings) {
    const auto speed = ground_speed(look, sighting);
    if (sighting.range < kNearest || !speed) continue;
    if (std::abs(*speed) < kStands) follow(look, sighting);
    if (const auto turn = turn_by_range_rate(look, sighting)) turn_.add(*turn);
  }
  if (things_.size() + fresh_.size() > kMostThings) things_.clear();
  things_.insert(things_.end(), fresh_.begin(), fresh_.end());
}

void StandingThings::follow(const SightingSet& look, const Sighting& sighting) {
  Thing* known = nullptr;
  int candidates = 0;
  for (Thing& thing : things_) {
    const Pose2 now_from_then = look.odometry_from_sensor.inverse() * thing.odometry_from_sensor;
    const double range = seen_now(now_from_then, thing.sighting.range, thing.sighting.bearing).norm();
    if (std::abs(sighting.range - range) > kRangeGate) continue;
    const Readings read = readings(now_from_then, thing.sighting);
    const double middle = read.as_said + wrap_angle(read.mirrored - read.as_said) / 2;
    const double gate = std::abs(wrap_angle(read.mirrored - read.as_said)) / 2 + 4 * sighting.bearing_sigma +
                        kWander / sighting.range + std::abs(1 - read.spreading) * kMostTurn * kDegree;
    if (std::abs(wrap_angle(sighting.bearing - middle)) > gate) continue;
    ++candidates;
    known = &thing;
  }
  if (candidates == 0) fresh_.push_back({look.measured_at, look.odometry_from_sensor, sighting});
  if (candidates != 1) return;  // which of several it is, nobody knows
  if (to_seconds(look.measured_at - known->seen_at) < kShortest) return;
  compare(look, sighting, *known);
  *known = {look.measured_at, look.odometry_from_sensor, sighting};
}

void StandingThings::compare(const SightingSet& look, const Sighting& sighting, const Thing& thing) {
  constexpr double kMostWord = 2;         // of one pair, however clear
  constexpr double kClear = 2 * kDegree;  // of a turn that one pair tells of
  const Pose2 now_from_then = look.odometry_from_sensor.inverse() * thing.odometry_from_sensor;
  const Readings read = readings(now_from_then, thing.sighting);
  const double sigma = std::hypot(std::numbers::sqrt2 * sighting.bearing_sigma, kWander / sighting.range);
  const double apart = wrap_angle(read.as_said - read.mirrored);
  const double surprise = wrap_angle(sighting.bearing - read.as_said);
  const double word = std::clamp(apart * (surprise + apart / 2) / (sigma * sigma), -kMostWord, kMostWord);
  word > 0 ? mirror_.sound += word : mirror_.wrong -= word;
  const double lever = 1 - read.spreading;
  if (sigma < kClear * std::abs(lever)) turn_.add(surprise / lever);
}

void StandingThings::forget(double keep) {
  mirror_.forget(keep);
  turn_.forget(keep);
}

void StandingThings::clear() {
  mirror_ = {};
  turn_ = {};
}

}  // namespace lanefuse
