// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/lateral_motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kChangeTime = 4;  ///< [s] of a lane change
constexpr double kReaction = 0.8;  ///< [s] of the hands, and of the car

/// Two lags of the reaction take away some of the wander's variance; its intent is larger by this factor.
double intent_gain(double tau) {
  const double kept = tau / (tau + kReaction);
  return 1 / std::sqrt((kept * kept + kept) / 2);
}

}  // namespace

LateralMotion::LateralMotion(double lane_centre, const Style& style, Random& random)
    : style_(style),
      change_time_(kChangeTime),
      from_{lane_centre},
      to_{lane_centre},
      intent_(style.wander_sigma * intent_gain(style.wander_tau), style.wander_tau, random),
      hand_(wish()),
      wheel_(wish()) {}

double LateralMotion::wish() const {
  return std::clamp(style_.bias + intent_.value(), -style_.room, style_.room);
}

void LateralMotion::advance(double seconds, Haste haste, Random& random) {
  haste_ = haste;
  seconds *= haste.share;
  intent_.advance(seconds, random);
  const double hand_speed = (wish() - hand_) / kReaction;
  const double wheel_speed = (hand_ - wheel_) / kReaction;
  hand_ += seconds * hand_speed;
  wheel_ += seconds * wheel_speed;
  progress_ = std::min(1.0, progress_ + seconds / change_time_);
}

void LateralMotion::change_to(const State& lane_centre) {
  assert(!changing());
  from_ = to_;
  to_ = lane_centre;
  progress_ = 0;
}

/// The S-curve of least jerk, 10 p^3 - 15 p^4 + 6 p^5, between two lanes that may move themselves.
LateralMotion::State LateralMotion::state() const {
  const double p = progress_;
  const double way = to_.position - from_.position;
  const double way_speed = to_.speed - from_.speed;
  const double way_acceleration = to_.acceleration - from_.acceleration;
  const double wheel_speed = (hand_ - wheel_) / kReaction;
  const double hand_speed = (wish() - hand_) / kReaction;

  const double curve = p * p * p * (10 + p * (6 * p - 15));
  const double curve_speed = haste_.share / change_time_ * 30 * p * p * (1 + p * (p - 2));
  const double own_speed =
      way / change_time_ * 30 * p * p * (1 + p * (p - 2)) + wheel_speed;  // at its own pace
  const double own_acceleration = way / (change_time_ * change_time_) * 60 * p * (1 + p * (2 * p - 3)) +
                                  (hand_speed - wheel_speed) / kReaction;
  return {from_.position + way * p * p * p * (10 + p * (6 * p - 15)) + wheel_,
          haste_.share * own_speed + from_.speed + way_speed * curve,
          haste_.share * haste_.share * own_acceleration + haste_.change * own_speed + from_.acceleration +
              way_acceleration * curve + 2 * way_speed * curve_speed};
}

}  // namespace lanefuse
