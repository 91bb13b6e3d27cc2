// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/lane_roles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "evaluation/true_road_view.hpp"

namespace lanefuse {
namespace {

constexpr double kAcrossAJoint =
    1.0;  // [m] along and across, from where a line ends to where the next begins

using Lines = std::vector<LineAhead>;

/// Whether line `after` goes on where line `before` ends at `x`; a line goes on as itself too.
bool goes_on(const LineAhead& before, const LineAhead& after, double x) {
  const std::optional<double> there = after.y(x + kAcrossAJoint);
  return there && std::abs(*there - *before.y(x)) < kAcrossAJoint;
}

/// The stretches of a lane's outer line along which the lane is wide enough.
void add_lane_edge(const LineAhead& outer, const LineAhead& inner, RoleLine& role) {
  LineAhead piece;
  for (const Eigen::Vector2d& point : outer.points()) {
    const std::optional<double> inner_y = inner.y(point.x());
    if (inner_y && std::abs(point.y() - *inner_y) >= TrueLanes::kNarrowest) {
      piece.extend(point);
    } else {
      role.add(std::exchange(piece, {}));
    }
  }
  role.add(std::move(piece));
}

double offset_of(const LaneEstimate& estimate, std::uint64_t boundary) {
  return find_boundary(estimate, boundary)->clothoid.lateral_offset;
}

/// The lane that answers for the true ego lane, whose left boundary is at `true_left` beside the car.
const Lane* answering_lane(const LaneEstimate& estimate, std::optional<double> true_left) {
  const Lane* ego = ego_lane(estimate);
  if (!ego || !true_left) return ego;
  const Lane* answer = ego;
  const double left = offset_of(estimate, ego->left_boundary);
  const double right = offset_of(estimate, ego->right_boundary);
  if (left < kOnTheLine && ego->left_lane && *true_left - left > left - right - 2 * kOnTheLine) {
    answer = find_lane(estimate, *ego->left_lane);
  }
  if (-right < kOnTheLine && ego->right_lane && left - *true_left > left - right - 2 * kOnTheLine) {
    answer = find_lane(estimate, *ego->right_lane);
  }
  return answer;
}

}  // namespace

EstimatedRoles estimated_roles(const LaneEstimate& estimate, const TrueRoles& truth) {
  const Lane* ego = answering_lane(estimate, truth[kEgoLeft].y(0));
  if (!ego) return {};
  const Lane* left = ego->left_lane ? find_lane(estimate, *ego->left_lane) : nullptr;
  const Lane* right = ego->right_lane ? find_lane(estimate, *ego->right_lane) : nullptr;
  return {find_boundary(estimate, ego->left_boundary), find_boundary(estimate, ego->right_boundary),
          left ? find_boundary(estimate, left->left_boundary) : nullptr,
          right ? find_boundary(estimate, right->right_boundary) : nullptr};
}

void RoleLine::add(LineAhead piece) {
  if (piece.points().size() >= 2) pieces_.push_back(std::move(piece));
}

std::optional<double> RoleLine::y(double x) const {
  for (const LineAhead& piece : pieces_) {
    if (const auto y = piece.y(x)) return y;
  }
  return std::nullopt;
}

std::optional<double> RoleLine::deviation(const Eigen::Vector2d& point) const {
  for (const LineAhead& piece : pieces_) {
    if (piece.y(point.x())) return piece.deviation(point);
  }
  return std::nullopt;
}

TrueLanes::TrueLanes(const TrueRoad& road) : bounding_(road.boundaries.size(), false) {
  std::map<std::uint64_t, std::size_t> boundary_of;
  for (std::size_t i = 0; i < road.boundaries.size(); ++i) boundary_of[road.boundaries[i].id] = i;
  std::vector<const TrueLane*> lanes;
  for (const TrueLane& lane : road.lanes) {
    const auto left = boundary_of.find(lane.left_boundary);
    const auto right = boundary_of.find(lane.right_boundary);
    if (left == boundary_of.end() || right == boundary_of.end()) continue;
    edges_.push_back({left->second, right->second});
    bounding_[left->second] = bounding_[right->second] = true;
    lanes.push_back(&lane);
  }
  left_of_.resize(lanes.size());
  right_of_.resize(lanes.size());
  for (std::size_t a = 0; a < lanes.size(); ++a) {
    for (std::size_t b = 0; b < lanes.size(); ++b) {
      const bool linked = lanes[a]->left_lane == lanes[b]->id || lanes[b]->right_lane == lanes[a]->id;
      if (a == b || !(linked || edges_[a].left == edges_[b].right)) continue;
      left_of_[a].push_back(b);
      right_of_[b].push_back(a);
    }
  }
}

std::optional<std::size_t> TrueLanes::ego_lane(const Lines& lines) const {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const std::optional<double> left = lines[edges_[i].left].y(0);
    const std::optional<double> right = lines[edges_[i].right].y(0);
    if (left && right && *left > 0 && *right <= 0) return i;
  }
  return std::nullopt;
}

bool TrueLanes::continues(std::size_t lane, std::size_t next, const Lines& lines) const {
  const LineAhead& left = lines[edges_[lane].left];
  const LineAhead& right = lines[edges_[lane].right];
  const double end = std::min(left.points().back().x(), right.points().back().x());
  return end < TrueRoadView::kViewAhead && left.y(end) && right.y(end) &&
         goes_on(left, lines[edges_[next].left], end) && goes_on(right, lines[edges_[next].right], end);
}

std::vector<std::size_t> TrueLanes::ahead_of(std::size_t lane, const Lines& lines) const {
  std::vector<std::size_t> chain{lane};
  for (bool found = true; found;) {
    found = false;
    for (std::size_t next = 0; next < edges_.size() && !found; ++next) {
      if (std::find(chain.begin(), chain.end(), next) != chain.end()) continue;
      found = continues(chain.back(), next, lines);
      if (found) chain.push_back(next);
    }
  }
  return chain;
}

TrueRoles TrueLanes::roles(const Lines& lines) const {
  TrueRoles roles;
  const std::optional<std::size_t> ego = ego_lane(lines);
  if (!ego) return roles;
  std::vector<std::size_t> seen;
  const auto add_once = [&](std::size_t boundary, LaneRole role) {
    if (std::find(seen.begin(), seen.end(), boundary) != seen.end()) return;
    seen.push_back(boundary);
    roles[role].add(lines[boundary]);
  };
  for (const std::size_t lane : ahead_of(*ego, lines)) {
    add_once(edges_[lane].left, kEgoLeft);
    add_once(edges_[lane].right, kEgoRight);
    for (const std::size_t left : left_of_[lane]) {
      add_lane_edge(lines[edges_[left].left], lines[edges_[left].right], roles[kAdjacentLeft]);
    }
    for (const std::size_t right : right_of_[lane]) {
      add_lane_edge(lines[edges_[right].right], lines[edges_[right].left], roles[kAdjacentRight]);
    }
  }
  return roles;
}

}  // namespace lanefuse
