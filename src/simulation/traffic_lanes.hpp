// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "simulation/lateral_motion.hpp"
#include "simulation/road.hpp"

namespace lanefuse {

/// What a road's lanes are to those who drive on it: where one may be, where one must leave, what is beside.
/// `side` is +1 for the left and -1 for the right.
class TrafficLanes {
 public:
  /// Drivers know of a lane's end this far ahead [m].
  static constexpr double kNotice = 400;

  explicit TrafficLanes(const Road& road);

  [[nodiscard]] const Road& road() const { return road_; }
  [[nodiscard]] int count() const { return static_cast<int>(stretches_.size()); }
  [[nodiscard]] bool is_driving(int lane) const { return kind(lane) == LaneKind::driving; }
  [[nodiscard]] bool is_entry(int lane) const { return kind(lane) == LaneKind::entry; }
  [[nodiscard]] bool is_exit(int lane) const { return kind(lane) == LaneKind::exit; }

  /// Stations between which the lane is wide enough for a truck; infinite where it runs to the road's end.
  [[nodiscard]] double begin(int lane) const { return stretches_[index(lane)].begin; }
  [[nodiscard]] double end(int lane) const { return stretches_[index(lane)].end; }
  [[nodiscard]] bool is_open(int lane, double station) const;
  /// A driving lane that goes on for a while.
  [[nodiscard]] bool is_through(int lane, double station) const;

  [[nodiscard]] std::optional<int> beside(int lane, int side, double station) const;
  [[nodiscard]] std::optional<int> through_beside(int lane, int side, double station) const;
  [[nodiscard]] int through_count(double station) const;
  /// Of the lanes at a place, from left to right, the one in the middle: where the ego car starts.
  [[nodiscard]] int middle(double station) const;
  /// How many through lanes are to the right of the lane.
  [[nodiscard]] int count_right_of(int lane, double station) const;

  /// Along the road.
  struct Progress {
    double station = 0;       ///< [m]
    double speed = 0;         ///< [m/s]
    double acceleration = 0;  ///< [m/s^2]
  };
  /// How the lane's centre moves across the road under a vehicle that moves along it.
  [[nodiscard]] LateralMotion::State centre(int lane, const Progress& vehicle) const;
  /// How far [m] a body of this width may be off the lane's centre, so that vehicles side by side never
  /// touch: the least within `ahead` [m].
  [[nodiscard]] double room(int lane, double station, double ahead, double width) const;

 private:
  struct Stretch {
    double begin;
    double end;
  };
  const Road& road_;
  std::vector<Stretch> stretches_;

  [[nodiscard]] static std::size_t index(int lane) { return static_cast<std::size_t>(lane); }
  [[nodiscard]] LaneKind kind(int lane) const { return road_.lane_kind(lane); }
  [[nodiscard]] double within(int lane, double station) const;
  [[nodiscard]] double width_of(int lane, double station) const;
  [[nodiscard]] Stretch usable_stretch(int lane) const;
};

}  // namespace lanefuse
