// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {

/// How a driver moves across the road: a lane change is an S-curve, and within the lane nobody drives
/// straight. Position, speed and acceleration are continuous, as the yaw rate that follows from them must be.
/// The lanes' centres may move while one drives along them.
class LateralMotion {
 public:
  struct Style {
    double wander_sigma = 0;  ///< [m]
    double wander_tau = 1;    ///< [s]
    double bias = 0;          ///< [m] this driver's own place in the lane
    double room = 1;  ///< [m] nobody strays further from the middle of the lane, lest they meet a neighbour
  };
  struct State {
    double position = 0;      ///< [m] across the road
    double speed = 0;         ///< [m/s]
    double acceleration = 0;  ///< [m/s^2]
  };
  /// How fast the motion across goes, as a share of its own pace: a car that stands does not slide sideways.
  struct Haste {
    double share = 1;   ///< in [0, 1]
    double change = 0;  ///< [1/s] of the share
  };

  LateralMotion(double lane_centre, const Style& style, Random& random);

  void advance(double seconds, Haste haste, Random& random);
  /// Begins a change to the lane with this centre; the last one must be over.
  void change_to(const State& lane_centre);
  /// Lane changes last so many seconds from now on.
  void take_time(double seconds) { change_time_ = seconds; }
  [[nodiscard]] bool changing() const { return progress_ < 1; }

  /// Says where the lanes' centres are now: of the lane left behind and of the lane that it is in or changes
  /// to, which are the same between changes.
  void follow(const State& from, const State& to) {
    from_ = from;
    to_ = to;
  }
  void keep_within(double room) { style_.room = room; }
  [[nodiscard]] State state() const;

 private:
  Style style_;
  double change_time_;  ///< [s]
  State from_;
  State to_;
  double progress_ = 1;  ///< of the lane change, in [0, 1]
  Haste haste_;
  Wander intent_;
  double hand_;   ///< [m] the intent, after the driver's hands
  double wheel_;  ///< [m] and after the car

  [[nodiscard]] double wish() const;
};

}  // namespace lanefuse
