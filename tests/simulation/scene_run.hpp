// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"
#include "simulation/traffic.hpp"

namespace lanefuse::testing {

/// Traffic on a road, watched tick by tick without sensors.
class SceneRun {
 public:
  explicit SceneRun(std::uint64_t seed, RoadKind kind = RoadKind::gentle)
      : preset_(nominal_preset()),
        road_(kind, 12'000, preset_.road, seed),
        traffic_(road_, nominal_traffic(preset_), 400, seed) {}

  [[nodiscard]] const SensorPreset& preset() const { return preset_; }
  [[nodiscard]] const Road& road() const { return road_; }
  [[nodiscard]] const Traffic& traffic() const { return traffic_; }
  [[nodiscard]] Scene scene() const { return traffic_.scene(from_nanoseconds(ticks_ * 20'000'000)); }
  void advance() {
    traffic_.advance(0.02);
    ++ticks_;
  }

  /// Lets `sensor` observe for `seconds`, and shows each scene with what was measured in it.
  template <typename Seen>
  void watch(SensorModel& sensor, double seconds, Seen seen) {
    const auto period = static_cast<int>(std::round(50 / sensor.hz()));
    std::vector<Measurement> measurements;
    for (int tick = 0; tick < static_cast<int>(seconds * 50); ++tick, advance()) {
      if (tick % period != 0) continue;
      measurements.clear();
      const Scene now = scene();
      sensor.observe(now, measurements);
      for (const Measurement& measurement : measurements) seen(now, measurement);
    }
  }

 private:
  SensorPreset preset_;
  Road road_;
  Traffic traffic_;
  std::int64_t ticks_ = 0;
};

/// (station, lateral) of a point of the ego car's frame.
inline Eigen::Vector2d place_of(const Scene& scene, const Eigen::Vector2d& in_vehicle) {
  const Eigen::Vector2d in_world = scene.ego.world_from_vehicle * in_vehicle;
  double station = scene.ego.station + in_vehicle.x();
  double lateral = 0;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector2d off = scene.road->reference().pose(station).inverse() * in_world;
    lateral = off.y();
    station += off.x() / (1 - scene.road->reference().curvature(station) * lateral);
  }
  return {station, lateral};
}

/// The line next to the place.
inline int nearest_line(const Road& road, const Eigen::Vector2d& place) {
  int nearest = 0;
  for (int line = 1; line < road.line_count(); ++line) {
    const auto distance = [&](int some) { return std::abs(place.y() - road.line_lateral(some, place.x())); };
    if (road.line_exists(line, place.x()) && distance(line) < distance(nearest)) nearest = line;
  }
  return nearest;
}

/// Sums up a sample's moments.
class Moments {
 public:
  void add(double x) {
    ++n_;
    sum_ += x;
    squares_ += x * x;
  }
  [[nodiscard]] double count() const { return n_; }
  [[nodiscard]] double mean() const { return sum_ / n_; }
  [[nodiscard]] double rms() const { return std::sqrt(squares_ / n_); }
  [[nodiscard]] double sigma() const { return std::sqrt(std::max(0.0, squares_ / n_ - mean() * mean())); }

 private:
  double n_ = 0;
  double sum_ = 0;
  double squares_ = 0;
};

}  // namespace lanefuse::testing
