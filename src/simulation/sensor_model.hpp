// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

/// A simulated sensor: looks at the scene at its own rate and hands over what a real one would, when it
/// would. Each model has its own stream of random numbers, so that none disturbs another.
class SensorModel {
 public:
  virtual ~SensorModel() = default;
  [[nodiscard]] virtual SensorDescription description() const = 0;
  [[nodiscard]] virtual double hz() const = 0;
  /// Appends what it measured at `scene.time`; called once a period.
  virtual void observe(const Scene& scene, std::vector<Measurement>& measurements) = 0;
};

inline Stamp stamp(const SensorDescription& sensor, Time measured_at, double latency) {
  return {measured_at, measured_at + from_seconds(latency), sensor.id};
}

}  // namespace lanefuse
