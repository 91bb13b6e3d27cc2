// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/lateral_course.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lanefuse {
namespace {

using Knots = std::vector<LateralCourse::Knot>;

[[maybe_unused]] bool in_order(const Knots& knots) {
  const auto not_after = [](const auto& a, const auto& b) { return b.station <= a.station; };
  return std::adjacent_find(knots.begin(), knots.end(), not_after) == knots.end();
}

/// The first knot beyond `station`.
Knots::const_iterator knot_after(const Knots& knots, double station) {
  return std::upper_bound(knots.begin(), knots.end(), station,
                          [](double s, const LateralCourse::Knot& knot) { return s < knot.station; });
}

}  // namespace

LateralCourse::LateralCourse(double lateral) : knots_{{0, lateral, 0}} {}

LateralCourse::LateralCourse(std::vector<Knot> knots) : knots_(std::move(knots)) {
  assert(!knots_.empty() && in_order(knots_));
}

double LateralCourse::at(double station) const {
  const auto after = knot_after(knots_, station);
  if (after == knots_.begin()) return after->lateral;
  const Knot& a = *(after - 1);
  if (after == knots_.end()) return a.lateral;
  const Knot& b = *after;
  const double length = b.station - a.station;
  const double t = (station - a.station) / length;
  const double rest = 1 - t;
  return rest * rest * ((1 + 2 * t) * a.lateral + t * length * a.slope) +
         t * t * ((3 - 2 * t) * b.lateral - rest * length * b.slope);
}

double LateralCourse::slope(double station) const {
  const auto after = knot_after(knots_, station);
  if (after == knots_.begin() || after == knots_.end()) return 0;
  const Knot& a = *(after - 1);
  const Knot& b = *after;
  const double length = b.station - a.station;
  const double t = (station - a.station) / length;
  return 6 * t * (1 - t) * (b.lateral - a.lateral) / length + (1 - t) * (1 - 3 * t) * a.slope +
         t * (3 * t - 2) * b.slope;
}

void LateralCourse::swing(double from, double to, double lateral) {
  assert(from < to);
  const double start = at(from);
  std::erase_if(knots_, [from](const Knot& knot) { return knot.station >= from; });
  knots_.push_back({from, start, 0});
  knots_.push_back({to, lateral, 0});
}

}  // namespace lanefuse
