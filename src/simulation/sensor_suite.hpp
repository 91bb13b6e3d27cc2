// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "sensors/truth.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// The moment at which simulated drives begin: 9 October 2016, 00:00 UTC.
inline constexpr Time kSimulationStart = from_nanoseconds(1'475'971'200'000'000'000);
inline constexpr Duration kTick{20'000'000};

/// All sensors of a simulated car, each at its own rate, and what they measured but is not yet received. A
/// sensor looks at the first tick at or after each of its periods: at a rate that does not divide the ticks'
/// (15 Hz), its looks are spaced unevenly and right in the mean.
class SensorSuite {
 public:
  /// Truth is told `truth_hz` times a second.
  explicit SensorSuite(double truth_hz);
  /// Throws a configuration error if the sensor is faster than the ticks.
  void add(std::unique_ptr<SensorModel> sensor);
  [[nodiscard]] Rig rig() const;

  /// Of the scene that comes next: what is received in its tick, in the order of receiving, and how things
  /// are. With the last scene comes whatever is still on its way.
  void look(const Scene& scene, bool is_last, std::vector<Measurement>& measurements,
            std::vector<TrueFrame>& truth);
  /// When the next scene is.
  [[nodiscard]] Time next() const { return kSimulationStart + ticks_ * kTick; }

 private:
  double truth_hz_;
  std::vector<std::unique_ptr<SensorModel>> sensors_;
  std::int64_t ticks_ = 0;
  /// By time of receiving and sensor.
  std::multimap<std::pair<Time, std::uint32_t>, Measurement> on_their_way_;

  [[nodiscard]] bool is_due(double hz) const;
  void measure(const Scene& scene);
  void hand_out(Time now, std::vector<Measurement>& measurements);
};

}  // namespace lanefuse
