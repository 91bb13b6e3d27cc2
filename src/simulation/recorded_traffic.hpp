// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/recorded_motion.hpp"
#include "simulation/traffic_model.hpp"

namespace lanefuse {

/// Traffic as it was recorded, with one of the vehicles as the ego car. Its front axle is taken to lie
/// kFrontOverhang behind its bumper.
///
/// The scene has no road: stations are ways along each vehicle's own path, and its lanes are not known.
/// Sensors that look at the road cannot be used.
class RecordedTraffic final : public TrafficModel {
 public:
  static constexpr double kFrontOverhang = 0.9;  ///< [m]

  /// Begins when the ego car's recording does. `ego` is the id of one of the vehicles.
  RecordedTraffic(const std::vector<RecordedVehicle>& vehicles, std::int64_t ego);

  void advance(double seconds) override { time_ += seconds; }
  [[nodiscard]] Scene scene(Time time) const override;

  [[nodiscard]] bool is_over() const { return time_ > ego_.motion.end(); }
  [[nodiscard]] double progress() const;  ///< in [0, 1]

 private:
  struct Recorded {
    std::int64_t id;
    double front;  ///< [m]
    double rear;   ///< [m]
    double width;  ///< [m]
    RecordedMotion motion;
  };
  Recorded ego_;
  std::vector<Recorded> others_;
  double time_;  ///< [s] of the recording

  static Recorded make_ego(const RecordedVehicle& vehicle);
  static Recorded make_other(const RecordedVehicle& vehicle);
  [[nodiscard]] SceneVehicle now(const Recorded& recorded) const;
};

/// The vehicle with that id; nothing where there is none.
const RecordedVehicle* find_vehicle(const std::vector<RecordedVehicle>& vehicles, std::int64_t id);

/// The one that was recorded for the longest time; the first of several.
const RecordedVehicle& longest_stay(const std::vector<RecordedVehicle>& vehicles);

}  // namespace lanefuse
