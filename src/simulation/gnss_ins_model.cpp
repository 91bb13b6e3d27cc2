// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/gnss_ins_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLookHz = 50;  ///< of the simulator's ticks

int fixes_a_look(double hz) {
  if (hz <= kLookHz) return 1;
  const double fixes = hz / kLookHz;
  if (std::abs(fixes - std::round(fixes)) > 1e-6) {
    throw configuration_error("preset", fmt::format("gnss_ins at {} Hz: no multiple of 50 Hz", hz));
  }
  return static_cast<int>(std::round(fixes));
}

}  // namespace

GnssInsModel::GnssInsModel(const SensorPreset& preset, const GeoOrigin& origin, std::uint64_t seed)
    : preset_(preset.gnss_ins),
      noise_(preset.noise),
      frame_(origin),
      random_(seed, "gnss ins"),
      position_errors_{Wander(preset_.position, preset_.position_tau, random_),
                       Wander(preset_.position, preset_.position_tau, random_),
                       Wander(preset_.position, preset_.position_tau, random_)},
      heading_error_(preset_.heading, preset_.position_tau, random_),
      fixes_a_look_(fixes_a_look(preset_.hz)) {}

SensorDescription GnssInsModel::description() const { return {5, SensorKind::gnss_ins, "GNSS/INS", {}}; }

GnssInsFix GnssInsModel::fix(Time time, const Pose2& world_from_vehicle) const {
  const auto& [east, north, up] = position_errors_;
  const GeoOrigin there =
      frame_.place({world_from_vehicle.x + east.value(), world_from_vehicle.y + north.value(), up.value()});
  const double stated = preset_.position / noise_;
  const double heading = world_from_vehicle.heading + heading_error_.value() - frame_.convergence(there);
  return {.stamp = stamp(description(), time, 0),
          .latitude = there.latitude_deg * kDegree,
          .longitude = there.longitude_deg * kDegree,
          .height = there.height,
          .heading = wrap_angle(heading),
          .position_covariance = stated * stated * Eigen::Matrix3d::Identity(),
          .heading_sigma = preset_.heading / noise_,
          .kind = FixKind::rtk_fixed};
}

void GnssInsModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  const Seen now{scene.time, scene.ego.world_from_vehicle};
  const Seen from = last_.value_or(now);
  for (int i = last_ ? 1 : fixes_a_look_; i <= fixes_a_look_; ++i) {
    const double fraction = static_cast<double>(i) / fixes_a_look_;
    for (Wander& error : position_errors_) error.advance(1 / preset_.hz, random_);
    heading_error_.advance(1 / preset_.hz, random_);
    const Time time = from.time + from_seconds(fraction * to_seconds(now.time - from.time));
    measurements.emplace_back(
        fix(time, interpolate(from.world_from_vehicle, now.world_from_vehicle, fraction)));
  }
  last_ = now;
}

}  // namespace lanefuse
