// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/exact_truth.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace lanefuse {
namespace {

enum Role : std::size_t { kEgoLeft, kEgoRight, kAdjacentLeft, kAdjacentRight, kRoleCount };

constexpr double kFalseBeyond = 1.0;     // [m] from every true boundary
constexpr double kFalseJudgedAt = 20.0;  // [m] ahead, or as near to that as the boundary reaches

/// The true boundary of that id as it lies ahead, or null.
const LineAhead* line_of(const TrueRoad& road, const std::vector<LineAhead>& lines, std::uint64_t id) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (road.boundaries[i].id == id) return &lines[i];
  }
  return nullptr;
}

const TrueLane* find_true_lane(const TrueRoad& road, std::optional<std::uint64_t> id) {
  const auto found =
      std::find_if(road.lanes.begin(), road.lanes.end(), [id](const auto& lane) { return lane.id == id; });
  return found == road.lanes.end() ? nullptr : &*found;
}

const TrueLane* true_ego_lane(const TrueRoad& road, const std::vector<LineAhead>& lines) {
  for (const TrueLane& lane : road.lanes) {
    const LineAhead* left = line_of(road, lines, lane.left_boundary);
    const LineAhead* right = line_of(road, lines, lane.right_boundary);
    if (!left || !right) continue;
    const std::optional<double> left_y = left->y(0);
    const std::optional<double> right_y = right->y(0);
    if (left_y && right_y && *left_y > 0 && *right_y <= 0) return &lane;
  }
  return nullptr;
}

using TrueRoles = std::array<const LineAhead*, kRoleCount>;

TrueRoles true_roles(const TrueRoad& road, const std::vector<LineAhead>& lines) {
  const TrueLane* ego = true_ego_lane(road, lines);
  if (!ego) return {};
  const TrueLane* left = find_true_lane(road, ego->left_lane);
  const TrueLane* right = find_true_lane(road, ego->right_lane);
  return {line_of(road, lines, ego->left_boundary), line_of(road, lines, ego->right_boundary),
          left ? line_of(road, lines, left->left_boundary) : nullptr,
          right ? line_of(road, lines, right->right_boundary) : nullptr};
}

using EstimatedRoles = std::array<const Boundary*, kRoleCount>;

EstimatedRoles estimated_roles(const LaneEstimate& estimate) {
  const Lane* ego = ego_lane(estimate);
  if (!ego) return {};
  const Lane* left = ego->left_lane ? find_lane(estimate, *ego->left_lane) : nullptr;
  const Lane* right = ego->right_lane ? find_lane(estimate, *ego->right_lane) : nullptr;
  return {find_boundary(estimate, ego->left_boundary), find_boundary(estimate, ego->right_boundary),
          left ? find_boundary(estimate, left->left_boundary) : nullptr,
          right ? find_boundary(estimate, right->right_boundary) : nullptr};
}

bool reaches(const Boundary& boundary, double x) {
  return boundary.range_begin <= x && x <= boundary.range_end;
}

/// The sigma that the boundary states at `x`, between its points; 0 where it has none.
double sigma_at(const Boundary& boundary, double x) {
  const auto& points = boundary.points;
  const auto after = std::lower_bound(points.begin(), points.end(), x,
                                      [](const BoundaryPoint& point, double at) { return point.x < at; });
  if (after == points.end()) return points.empty() ? 0 : points.back().sigma;
  if (after == points.begin()) return after->sigma;
  const BoundaryPoint& before = *(after - 1);
  return std::lerp(before.sigma, after->sigma, (x - before.x) / (after->x - before.x));
}

/// The true boundary that is nearest to `y` beside the car's origin.
const LineAhead* nearest_beside(const std::vector<LineAhead>& lines, double y) {
  const LineAhead* nearest = nullptr;
  double smallest = std::numeric_limits<double>::infinity();
  for (const LineAhead& line : lines) {
    const std::optional<double> line_y = line.y(0);
    if (!line_y || std::abs(*line_y - y) >= smallest) continue;
    smallest = std::abs(*line_y - y);
    nearest = &line;
  }
  return nearest;
}

/// Whether the boundary is far from every true line; not where no true line can say.
bool is_false(const Boundary& boundary, const std::vector<LineAhead>& lines) {
  const double x = std::max(boundary.range_begin, std::min(kFalseJudgedAt, boundary.range_end));
  bool any_truth = false;
  for (const LineAhead& line : lines) {
    if (!line.y(x)) continue;
    if (std::abs(line.deviation({x, boundary.clothoid.y(x)})) <= kFalseBeyond) return false;
    any_truth = true;
  }
  return any_truth;
}

}  // namespace

void ExactTruthEvaluation::add_without_truth(const LaneEstimate& estimate) {
  ++counts_.cycles;
  if (estimate.status == EstimateStatus::ok) ++counts_.cycles_ok;
}

void ExactTruthEvaluation::add(const LaneEstimate& estimate, const TrueFrame& frame) {
  assert(frame.time == estimate.time);
  add_without_truth(estimate);
  const TrueRoles truth = true_roles(road_, view_.look_from(frame.world_from_vehicle));
  if (!truth[kEgoLeft]) return;
  ++counts_.cycles_with_truth;
  const EstimatedRoles estimated = estimated_roles(estimate);
  for (std::size_t role = 0; role < kRoleCount; ++role) {
    if (truth[role]) compare(estimated[role], *truth[role], role <= kEgoRight ? ego_ : adjacent_);
  }
  judge_assignment(estimate, *truth[kEgoLeft], *truth[kEgoRight]);
  count_false_boundaries(estimate);
}

void ExactTruthEvaluation::compare(const Boundary* estimated, const LineAhead& truth, Group& group) {
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    const double x = distance_at(i);
    if (!truth.y(x)) continue;
    if (!estimated || !reaches(*estimated, x)) {
      group.deviations.add(i, std::nullopt);
      continue;
    }
    const double deviation = truth.deviation({x, estimated->clothoid.y(x)});
    group.deviations.add(i, deviation);
    group.consistency.add(i, deviation, sigma_at(*estimated, x));
  }
}

void ExactTruthEvaluation::judge_assignment(const LaneEstimate& estimate, const LineAhead& true_left,
                                            const LineAhead& true_right) {
  const EstimatedRoles estimated = estimated_roles(estimate);
  if (!estimated[kEgoLeft]) return;
  ++counts_.cycles_with_ego_lane;
  const auto& lines = view_.lines();
  const bool right_lane = nearest_beside(lines, estimated[kEgoLeft]->clothoid.lateral_offset) == &true_left &&
                          nearest_beside(lines, estimated[kEgoRight]->clothoid.lateral_offset) == &true_right;
  if (!right_lane) ++counts_.cycles_in_wrong_lane;
}

void ExactTruthEvaluation::count_false_boundaries(const LaneEstimate& estimate) {
  for (const Boundary& boundary : estimate.boundaries) {
    if (is_false(boundary, view_.lines())) ++counts_.false_boundaries;
  }
}

EvaluationResult ExactTruthEvaluation::result() const {
  EvaluationResult result = counts_;
  result.truth = "exact";
  result.lanes = {ego_.deviations.statistics(), adjacent_.deviations.statistics()};
  result.consistency = {ego_.consistency.statistics(), adjacent_.consistency.statistics()};
  return result;
}

}  // namespace lanefuse
