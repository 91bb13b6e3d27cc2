// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/place_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace lanefuse {

namespace {

using Pair = std::pair<Pose2, Pose2>;

std::map<std::int64_t, Pose2> places_by_id(const G2oGraph& g) {
  std::map<std::int64_t, Pose2> places;
  for (std::size_t v = 0; v < g.graph.vertices.size(); ++v) {
    const auto id = v < g.vertex_ids.size() ? g.vertex_ids[v] : static_cast<std::int64_t>(v);
    places.emplace(id, g.graph.vertices[v].pose);
  }
  return places;
}

/// The turn and shift that take the first places onto the second as well as they fit.
Pose2 alignment(const std::vector<Pair>& pairs) {
  Eigen::Vector2d middle_a = Eigen::Vector2d::Zero(), middle_b = middle_a;
  for (const auto& [a, b] : pairs) {
    middle_a += a.position() / static_cast<double>(pairs.size());
    middle_b += b.position() / static_cast<double>(pairs.size());
  }
  double along = 0, across = 0;
  for (const auto& [a, b] : pairs) {
    const Eigen::Vector2d p = a.position() - middle_a, q = b.position() - middle_b;
    along += p.dot(q);
    across += p.x() * q.y() - p.y() * q.x();
  }
  // A single place, or all in one, has no turn of its own: that of the headings is as good.
  const double turn = along == 0 && across == 0 ? pairs[0].second.heading - pairs[0].first.heading
                                                : std::atan2(across, along);
  const Eigen::Vector2d shift = middle_b - rotation(turn) * middle_a;
  return {shift.x(), shift.y(), turn};
}

}  // namespace

PlaceComparison compare_places(const G2oGraph& a, const G2oGraph& b) {
  const auto places_a = places_by_id(a), places_b = places_by_id(b);
  std::vector<Pair> pairs;
  for (const auto& [id, place] : places_a) {
    const auto partner = places_b.find(id);
    if (partner != places_b.end()) pairs.emplace_back(place, partner->second);
  }
  if (pairs.empty()) throw input_error("the two graphs", "have no vertex in common");
  PlaceComparison result{
      pairs.size(), places_a.size() - pairs.size(), places_b.size() - pairs.size(), 0, 0, 0};
  const Pose2 b_from_a = alignment(pairs);
  double squares = 0, heading_squares = 0;
  for (const auto& [place_a, place_b] : pairs) {
    const Pose2 moved = b_from_a * place_a;
    const double distance = (moved.position() - place_b.position()).norm();
    const double turn = wrap_angle(moved.heading - place_b.heading);
    squares += distance * distance;
    heading_squares += turn * turn;
    result.farthest = std::max(result.farthest, distance);
  }
  result.rmse = std::sqrt(squares / static_cast<double>(pairs.size()));
  result.heading_rmse = std::sqrt(heading_squares / static_cast<double>(pairs.size()));
  return result;
}

}  // namespace lanefuse
