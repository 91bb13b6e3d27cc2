// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "core/random.hpp"
#include "roadmap/geo_frame.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// An RTK-GNSS receiver with inertial sensors, at the origin of the vehicle frame, that has settled: every
/// coordinate of the position is wrong by a few centimetres, which wander over minutes, and so is the
/// heading. Nothing in it is white: the inertial sensors smooth it. It hands over at once.
///
/// Above the simulator's 50 Hz it looks once a tick, and interpolates the fixes that lie within the tick.
class GnssInsModel final : public SensorModel {
 public:
  /// Throws a configuration error where the preset's rate is above 50 Hz and no multiple of it.
  /// `origin` is the simulated world's.
  GnssInsModel(const SensorPreset& preset, const GeoOrigin& origin, std::uint64_t seed);
  [[nodiscard]] SensorDescription description() const override;
  [[nodiscard]] double hz() const override { return preset_.hz / fixes_a_look_; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  struct Seen {
    Time time;
    Pose2 world_from_vehicle;
  };

  GnssInsPreset preset_;
  double noise_;  ///< its errors are so many times as large as it states
  GeoFrame frame_;
  Random random_;
  std::array<Wander, 3> position_errors_;  ///< [m] to the east, the north and up
  Wander heading_error_;                   ///< [rad]
  int fixes_a_look_;
  std::optional<Seen> last_;

  [[nodiscard]] GnssInsFix fix(Time time, const Pose2& world_from_vehicle) const;
};

}  // namespace lanefuse
