// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.hpp"
#include "simulation/disturbed_sensor.hpp"

namespace lanefuse {

/// A sensor whose messages come late: all of them by the same time, or a share of them by a time of their
/// own, so that they overtake each other.
class LateMessages final : public DisturbedSensor {
 public:
  /// `share` of the messages comes later by up to `at_most` [s] and no less than `at_least`.
  struct Delays {
    double share = 0;
    double at_least = 0;  ///< [s]
    double at_most = 0;   ///< [s]
    double in_all = 0;    ///< [s] that every message takes at least, from measuring to receiving
  };

  LateMessages(std::unique_ptr<SensorModel> sensor, const Delays& delays, Random random)
      : DisturbedSensor(std::move(sensor)), delays_(delays), random_(random) {}
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  Delays delays_;
  Random random_;
};

}  // namespace lanefuse
