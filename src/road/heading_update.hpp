// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "road/road_state.hpp"

namespace lanefuse {

/// Takes in that something at `place` [m] of the vehicle frame goes along the road there with `heading`
/// [rad], give or take `variance`. Says nothing of where lines are, and so helps before any is known. What
/// contradicts the road's course is left out.
void take_heading(const Eigen::Vector2d& place, double heading, double variance, RoadState& state);

/// The variance of the road's heading at a station of its axis, against the car's.
double heading_variance(double station, const RoadState& state);

}  // namespace lanefuse
