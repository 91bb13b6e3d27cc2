// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/random.hpp"
#include "simulation/guard_rails.hpp"
#include "simulation/line_of_sight.hpp"
#include "simulation/radar_clutter.hpp"
#include "simulation/rail_mirrors.hpp"
#include "simulation/sensor_model.hpp"
#include "simulation/vehicle_reflections.hpp"

namespace lanefuse {

/// A radar that hands over what came back to it, scan by scan: some reflections of each vehicle that it
/// detects, clutter, and ghosts of vehicles mirrored in guard rails. It is turned by a misalignment that
/// nobody knows of, one a drive.
class RadarModel final : public SensorModel {
 public:
  struct Setup {
    SensorDescription sensor;  ///< whose name is also that of its random numbers
    RadarPreset radar;
    Range mirrors;  ///< seen in a scan
    std::shared_ptr<const GuardRails> rails;
  };

  RadarModel(const Setup& setup, std::uint64_t seed);
  [[nodiscard]] SensorDescription description() const override { return setup_.sensor; }
  [[nodiscard]] double hz() const override { return setup_.radar.hz; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  Setup setup_;
  Random random_;
  Random ghost_noise_;
  double misalignment_;  ///< [rad]
  VehicleReflections reflections_;
  VehicleReflections ghost_reflections_;
  RadarClutter clutter_;
  Random clutter_noise_;
  RailMirrors mirrors_;

  void see_vehicle(const SceneVehicle& vehicle, const RadarView& view, const LineOfSight& sight,
                   RadarScan& scan);
  [[nodiscard]] RadarDetection with_errors(const RadarDetection& exact, Random& random) const;
};

/// The radar in the middle of the front bumper, which looks ahead.
RadarModel::Setup long_range_radar_setup(const SensorPreset& preset, std::shared_ptr<const GuardRails> rails);

inline constexpr int kCorners = 4;
/// The radar at a corner of the car, which looks outwards: front left, front right, rear left, rear right.
RadarModel::Setup short_range_radar_setup(const SensorPreset& preset, std::shared_ptr<const GuardRails> rails,
                                          int corner);

}  // namespace lanefuse
