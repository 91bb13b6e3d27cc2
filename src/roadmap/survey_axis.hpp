// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "roadmap/survey_track.hpp"

namespace lanefuse {

/// The common longitudinal coordinate of a survey: the path of one drive, by arc length. A place beside it is
/// (station, lateral), positive to the left.
class SurveyAxis {
 public:
  struct Place {
    double station = 0;  ///< [m]
    double lateral = 0;  ///< [m]
  };

  /// Knots every `step` metres along the track, which leads at least that far.
  SurveyAxis(std::span<const TrackNode> track, double step);

  [[nodiscard]] std::size_t knot_count() const { return knots_.size(); }
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] const Pose2& knot(std::size_t i) const { return knots_[i]; }
  [[nodiscard]] double height(std::size_t i) const { return heights_[i]; }

  /// The place of a point beside the axis; none before its beginning, beyond its end, or further away than
  /// any road is wide. `hint` is where to begin the search, and takes the knot that was found.
  [[nodiscard]] std::optional<Place> locate(const Eigen::Vector2d& point, std::size_t& hint) const;

  /// A hint for a point that nothing is known of.
  [[nodiscard]] std::size_t nearest_knot(const Eigen::Vector2d& point) const;

 private:
  double step_;
  std::vector<Pose2> knots_;
  std::vector<double> heights_;

  [[nodiscard]] double ahead_of(std::size_t knot, const Eigen::Vector2d& point) const;
};

/// Metres that a track leads along.
double length_of(std::span<const TrackNode> track);

}  // namespace lanefuse
