// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/time.hpp"
#include "simulation/disturbance.hpp"
#include "simulation/disturbed_sensor.hpp"

namespace lanefuse {

/// A sensor whose messages are lost for a while, again and again. It looks on meanwhile: its tracks live.
class SensorGaps final : public DisturbedSensor {
 public:
  SensorGaps(std::unique_ptr<SensorModel> sensor, Disturbance disturbance)
      : DisturbedSensor(std::move(sensor)), gaps_(std::move(disturbance)) {}
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  Disturbance gaps_;
  std::optional<Time> start_;  ///< of the drive
};

}  // namespace lanefuse
