// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/heading_update.hpp"

namespace lanefuse {
namespace {

constexpr double kGate = 9;  ///< squared sigmas

SparseRow heading_row(double station, const RoadState& state) {
  SparseRow row;
  row.add(kHeading, -1);
  for (int k = 0; k < RoadAxis::kKnots; ++k) {
    const double centre = state.first_knot() + k * RoadAxis::kKnotSpacing;
    row.add(kCurvatures + k, hat_turn(centre, RoadAxis::kKnotSpacing, station));
  }
  return row;
}

}  // namespace

double heading_variance(double station, const RoadState& state) {
  return state.numbers().variance(heading_row(station, state));
}

void take_heading(const Eigen::Vector2d& place, double heading, double variance, RoadState& state) {
  state.rebuild_axis();
  const double station = state.axis().project(place).place.station;
  const double residual = wrap_angle(heading - state.axis().heading_at(station));
  const SparseRow row = heading_row(station, state);
  if (residual * residual > kGate * (state.numbers().variance(row) + variance)) return;
  state.numbers().update(row, residual, variance);
}

}  // namespace lanefuse
