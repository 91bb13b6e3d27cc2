// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/feature.hpp"
#include "road/road_state.hpp"

namespace lanefuse {

/// Takes a tracked lane's clothoids in whole: its course (the middle of both sides, or one side alone) as
/// four correlated numbers, and its width as a fifth. Its tracker has filtered already and repeats itself:
/// the covariance is inflated by TrackedLaneConfig::inflation. Taken as independent samples instead, its word
/// would drown all others.
class TrackedLaneUpdate {
 public:
  explicit TrackedLaneUpdate(const RoadConfig& config) : config_(config) {}

  /// `moved` [m] by the car since the last one. Sides that are no line yet found one. Gives how many
  /// clothoids were taken.
  std::size_t take(const FeatureSet& set, const Pose2& now_from_measured, double moved, RoadState& state);

  /// The ids of the lines that the last set's clothoids were taken for, 0 where for none; one a clothoid.
  [[nodiscard]] std::span<const std::uint64_t> given_to() const { return given_to_; }

 private:
  /// The index of the line that the clothoid is of, or lines().size().
  std::size_t line_of(const ClothoidMeasurement& side, const Pose2& now_from_measured,
                      RoadState& state) const;
  void take_course(const ClothoidMeasurement& side, const ClothoidMeasurement* other,
                   const Pose2& now_from_measured, double inflation, RoadState& state, const KnownLine& line,
                   const KnownLine* other_line) const;

  RoadConfig config_;
  std::vector<std::uint64_t> given_to_;
};

}  // namespace lanefuse
