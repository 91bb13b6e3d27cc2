// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_body.hpp"

#include <numbers>

#include "simulation/sensor_suite.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

BodyMotion::BodyMotion(std::uint64_t seed)
    : random_(seed, "body of the car"),
      heave_(0.01, 0.5, random_),
      roll_(0.15 * kDegree, 0.5, random_),
      pitch_(0.25 * kDegree, 0.3, random_) {}

BodyMotion::Attitude BodyMotion::at(Time time) {
  if (!now_) now_ = time;
  for (; *now_ < time; *now_ += kTick) {
    heave_.advance(to_seconds(kTick), random_);
    roll_.advance(to_seconds(kTick), random_);
    pitch_.advance(to_seconds(kTick), random_);
  }
  return {heave_.value(), roll_.value(), pitch_.value()};
}

MountingError draw_mounting_error(Random& random) {
  MountingError error;
  error.height = random.normal(0.01);
  error.roll = random.normal(0.15 * kDegree);
  error.pitch = random.normal(0.3 * kDegree);
  error.yaw = random.normal(0.2 * kDegree);
  return error;
}

Mounting true_mounting(const Mounting& nominal, const MountingError& error,
                       const BodyMotion::Attitude& attitude) {
  Mounting mounting = nominal;
  mounting.z += error.height + attitude.heave;
  mounting.roll += error.roll + attitude.roll;
  mounting.pitch += error.pitch + attitude.pitch;
  mounting.yaw += error.yaw;
  return mounting;
}

}  // namespace lanefuse
