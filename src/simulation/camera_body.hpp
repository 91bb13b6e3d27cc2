// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "core/random.hpp"
#include "core/time.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// How the car's body moves over the road: what all its cameras share. A function of time alone, whoever asks
/// first.
class BodyMotion {
 public:
  explicit BodyMotion(std::uint64_t seed);

  struct Attitude {
    double heave = 0;  ///< [m] up
    double roll = 0;   ///< [rad]
    double pitch = 0;  ///< [rad], positive nose down
  };
  /// `time` must not go back; it is stepped by kTick from the first time asked for.
  Attitude at(Time time);

 private:
  Random random_;
  Wander heave_;
  Wander roll_;
  Wander pitch_;
  std::optional<Time> now_;
};

/// By how much a camera stands otherwise than its calibration says: drawn once a drive.
struct MountingError {
  double height = 0;  ///< [m]
  double roll = 0;    ///< [rad]
  double pitch = 0;   ///< [rad]
  double yaw = 0;     ///< [rad]
};
MountingError draw_mounting_error(Random& random);

/// The camera's true place and attitude over the road.
Mounting true_mounting(const Mounting& nominal, const MountingError& error,
                       const BodyMotion::Attitude& attitude);

}  // namespace lanefuse
