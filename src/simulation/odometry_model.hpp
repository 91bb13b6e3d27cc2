// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// Speed and yaw rate from the car's buses. The speed is wrong by one factor for the whole drive (tyre
/// radius), the yaw rate by one bias for the whole drive and by white noise a sample.
class OdometryModel final : public SensorModel {
 public:
  OdometryModel(const OdometryPreset& preset, std::uint64_t seed);
  [[nodiscard]] SensorDescription description() const override;
  [[nodiscard]] double hz() const override { return preset_.hz; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  OdometryPreset preset_;
  Random random_;
  double speed_factor_;
  double yaw_rate_bias_;  ///< [rad/s]
};

}  // namespace lanefuse
