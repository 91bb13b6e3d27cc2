// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "simulation/reference_line.hpp"

namespace lanefuse {

/// A smooth reference line along a polyline: its curvature is continuous, and it stays near the points, but
/// does not follow their corners. `points` are at least two and 50 m long in all.
std::optional<ReferenceLine> fit_reference_line(const std::vector<Eigen::Vector2d>& points);

}  // namespace lanefuse
