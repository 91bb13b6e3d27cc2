// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/false_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lanefuse {
namespace {

constexpr double kFalseBeyond = 1.0;  // [m]
constexpr double kJudgedAt = 20.0;    // [m] ahead

using Lines = std::vector<LineAhead>;

bool is_false(const Boundary& boundary, const TrueLanes& lanes, const Lines& lines) {
  const double x = std::max(boundary.range_begin, std::min(kJudgedAt, boundary.range_end));
  bool any_truth = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lanes.bounds_a_lane(i) || !lines[i].y(x)) continue;
    if (std::abs(lines[i].deviation({x, lateral_at(boundary, x)})) <= kFalseBeyond) return false;
    any_truth = true;
  }
  return any_truth;
}

bool is_false(const Boundary& left, const Boundary& right, const TrueLanes& lanes, const Lines& lines) {
  const double x =
      std::max({left.range_begin, right.range_begin, std::min({kJudgedAt, left.range_end, right.range_end})});
  const double left_y = lateral_at(left, x);
  const double right_y = lateral_at(right, x);
  const double centre = (left_y + right_y) / 2;
  bool any_truth = false;
  bool in_a_lane = false;
  for (const TrueLanes::Edges& lane : lanes.lanes()) {
    const std::optional<double> true_left = lines[lane.left].y(x);
    const std::optional<double> true_right = lines[lane.right].y(x);
    if (!true_left || !true_right) continue;
    any_truth = true;
    in_a_lane = in_a_lane || (*true_right <= centre && centre < *true_left);
    for (const double edge : {*true_left, *true_right}) {
      if (left_y - edge > kFalseBeyond && edge - right_y > kFalseBeyond) return true;
    }
  }
  return any_truth && !in_a_lane;
}

/// The true boundary's y beside the car that is nearest to `y`; infinite where there is none.
double nearest_beside(double y, const TrueLanes& lanes, const Lines& lines) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<double> line_y = lines[i].y(0);
    if (lanes.bounds_a_lane(i) && line_y && std::abs(*line_y - y) < std::abs(nearest - y)) nearest = *line_y;
  }
  return nearest;
}

}  // namespace

FalseCounts count_false(const LaneEstimate& estimate, const TrueLanes& lanes, const Lines& lines) {
  FalseCounts counts;
  for (const Boundary& boundary : estimate.boundaries) {
    if (is_false(boundary, lanes, lines)) ++counts.boundaries;
  }
  for (const Lane& lane : estimate.lanes) {
    const Boundary* left = find_boundary(estimate, lane.left_boundary);
    const Boundary* right = find_boundary(estimate, lane.right_boundary);
    if (left && right && is_false(*left, *right, lanes, lines)) ++counts.lanes;
  }
  return counts;
}

bool in_wrong_lane(const EstimatedRoles& estimated, const TrueRoles& truth, const TrueLanes& lanes,
                   const Lines& lines) {
  for (const LaneRole role : {kEgoLeft, kEgoRight}) {
    // The very same line gives the very same y.
    const double nearest = nearest_beside(estimated[role]->clothoid.lateral_offset, lanes, lines);
    if (nearest != truth[role].y(0)) return true;
  }
  return false;
}

}  // namespace lanefuse
