// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/preset.hpp"

namespace lanefuse {

/// How a driver moves across the road: a lane change is an S-curve, and within the lane nobody drives
/// straight. Position, speed and acceleration are continuous, as the yaw rate that follows from them must be.
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

  LateralMotion(double lane_centre, const Style& style, Random& random);

  void advance(double seconds, Random& random);
  /// Begins a lane change; the last one must be over.
  void change_to(double lane_centre);
  [[nodiscard]] bool changing() const { return progress_ < 1; }
  [[nodiscard]] State state() const;

 private:
  Style style_;
  double from_;
  double to_;
  double progress_ = 1;  ///< of the lane change, in [0, 1]
  Wander intent_;
  double hand_;   ///< [m] the intent, after the driver's hands
  double wheel_;  ///< [m] and after the car

  [[nodiscard]] double wish() const;
};

}  // namespace lanefuse
