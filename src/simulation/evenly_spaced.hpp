// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

namespace lanefuse {

/// Points along a polyline, `spacing` [m] apart, and its last one.
std::vector<Eigen::Vector2d> evenly_spaced(const std::vector<Eigen::Vector2d>& points, double spacing);

}  // namespace lanefuse
