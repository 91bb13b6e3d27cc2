// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>

#include <Eigen/Core>

#include "core/random.hpp"
#include "core/time.hpp"
#include "evaluation/lane_roles.hpp"

namespace lanefuse {

/// How far a map that was surveyed by car is off, and the car's place in it: sigma of each error. The
/// defaults are the nominal preset's, the paper's own map as its Table I shows it at 0 m.
struct SurveyedTruthConfig {
  double ego = 0.09;                               ///< [m] across, each boundary of the ego lane
  double adjacent = 0.19;                          ///< [m] across, each outer boundary of a neighbour lane
  double heading = 0.12 * std::numbers::pi / 180;  ///< [rad] turns all of the truth about the car
  std::uint64_t seed = 1;                          ///< the same seed gives the same errors
  friend bool operator==(const SurveyedTruthConfig&, const SurveyedTruthConfig&) = default;
};

/// The error of such a map around the car, as the car moves on. Every boundary is moved across as a whole by
/// an error that forgets within kForgetsWithin of way, and all are turned by one that forgets within
/// kForgetsAfter of time: stationary Ornstein-Uhlenbeck processes, so that the expected square of every
/// deviation is the same whatever these two are; they only say how many independent errors a drive holds
/// (24 km: some 240 a boundary, 160 of the heading).
class SurveyError {
 public:
  static constexpr double kForgetsWithin = 100;  ///< [m]
  static constexpr double kForgetsAfter = 5;     ///< [s]

  explicit SurveyError(const SurveyedTruthConfig& config);

  /// Moves on to where the car is at `time`; in order of time.
  void advance(Time time, const Eigen::Vector2d& position);

  /// The true line of that role as the survey has it.
  [[nodiscard]] RoleLine surveyed(const RoleLine& line, LaneRole role) const;

 private:
  struct Place {
    Time time{};
    Eigen::Vector2d position;
  };

  Random random_;
  std::array<Wander, kRoleCount> across_;
  Wander heading_;
  std::optional<Place> last_;
};

}  // namespace lanefuse
