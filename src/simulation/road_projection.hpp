// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "roadmap/road_map.hpp"
#include "simulation/lateral_course.hpp"
#include "simulation/reference_line.hpp"

namespace lanefuse {

/// A place on a road with how far along a boundary it was found.
struct ProjectedPoint {
  double station = 0;  ///< [m]
  double lateral = 0;  ///< [m]
  double along = 0;    ///< [m] of arc length along the boundary
};

/// The part of a boundary that runs beside the reference line in its direction, a point at least every metre
/// and in order of the stations; empty where there is none.
std::vector<ProjectedPoint> project(const ReferenceLine& reference, const MapBoundary& boundary);

/// A smooth course through the points, nowhere further than 1.5 cm off them.
LateralCourse course_through(const std::vector<ProjectedPoint>& points);

}  // namespace lanefuse
