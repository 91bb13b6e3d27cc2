// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "simulation/preset.hpp"
#include "simulation/road.hpp"
#include "simulation/vehicle.hpp"

namespace lanefuse {

inline constexpr std::int64_t kEgoId = 0;

/// What the ego car is told to do; otherwise it starts in the middle lane and changes it now and then.
struct EgoPlan {
  std::optional<int> lane;   ///< to start in, from the left, from zero
  bool lane_changes = true;  ///< whether it may leave it
};

/// The ego car and the vehicles within kTrafficReach of it.
///
/// Each lane has its usual speed; trucks keep to the right lane. Drivers follow their leader, wander in their
/// lane and change it when they have waited long enough and find a gap. Vehicles enter at the ends of the
/// reach as if the traffic went on there, and are forgotten beyond it. No vehicle ever runs into another.
class Traffic {
 public:
  /// The ego car starts at `start` [m].
  Traffic(const Road& road, const SensorPreset& preset, double start, std::uint64_t seed,
          const EgoPlan& plan = {});

  void advance(double seconds);

  [[nodiscard]] const Vehicle& ego() const { return vehicles_.front(); }
  /// The ego car first, the others in the order of their coming.
  [[nodiscard]] const std::vector<Vehicle>& vehicles() const { return vehicles_; }

 private:
  const Road& road_;
  TrafficPreset preset_;
  EgoPreset ego_preset_;
  Random random_;
  std::int64_t next_id_ = kEgoId + 1;
  std::vector<Vehicle> vehicles_;
  struct Headways {
    double front;  ///< [m] from the foremost vehicle to the next that enters
    double rear;   ///< [m] from the rearmost one
  };
  std::vector<Headways> headways_;  ///< a lane

  Vehicle make_ego(double start, const EgoPlan& plan);
  Vehicle make_vehicle(int lane, double station);
  void fill();
  void enter(int lane);
  void enter_at(int lane, double station, bool ahead);
  void forget_far_ones();
  void accelerate(Vehicle& vehicle) const;
  void consider_lane_change(Vehicle& vehicle, double seconds);
  int draw_wish(const Vehicle& vehicle);
  void wait_anew(Vehicle& vehicle);
  double draw_wait();
  [[nodiscard]] bool has_lane(int lane) const { return lane >= 0 && lane < road_.lane_count(); }
  [[nodiscard]] bool is_free_for(const Vehicle& vehicle, int lane) const;
  [[nodiscard]] double draw_headway();
};

inline constexpr double kTrafficReach = 300;  ///< [m] ahead of and behind the ego car

/// Where all of the traffic is.
Scene scene_at(Time time, const Road& road, const Traffic& traffic);

}  // namespace lanefuse
