// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/disturbance.hpp"
#include "simulation/disturbed_sensor.hpp"

namespace lanefuse {

/// A camera that does not see far: always (night), or on stretches of the road where it sees nothing (a
/// tunnel's mouth).
class PoorVisibility final : public DisturbedSensor {
 public:
  /// `start` [m]: station from which the stretches are counted.
  PoorVisibility(std::unique_ptr<SensorModel> sensor, Disturbance disturbance, double start)
      : DisturbedSensor(std::move(sensor)), disturbance_(std::move(disturbance)), start_(start) {}
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  Disturbance disturbance_;
  double start_;
};

}  // namespace lanefuse
