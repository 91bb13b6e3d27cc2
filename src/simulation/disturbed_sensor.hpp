// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// A sensor to which something happens.
class DisturbedSensor : public SensorModel {
 public:
  explicit DisturbedSensor(std::unique_ptr<SensorModel> sensor) : sensor_(std::move(sensor)) {}
  [[nodiscard]] SensorDescription description() const override { return sensor_->description(); }
  [[nodiscard]] double hz() const override { return sensor_->hz(); }

 protected:
  /// What the undisturbed sensor would have said.
  std::vector<Measurement> observe_undisturbed(const Scene& scene) {
    std::vector<Measurement> measured;
    sensor_->observe(scene, measured);
    return measured;
  }

 private:
  std::unique_ptr<SensorModel> sensor_;
};

/// Whether `at` lies in one of the pieces of `length` that begin at `first` and again `every` so much; 0:
/// only once.
bool recurs_at(double at, double first, double every, double length);

}  // namespace lanefuse
