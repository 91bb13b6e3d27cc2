// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lane_estimate.hpp"

namespace lanefuse {

/// A boundary as one smooth line: its clothoid, moved to where its points are. Between points it is as smooth
/// as the clothoid, and beyond their ends it goes on without a step. Where the points lie on the clothoid it
/// is the clothoid, to the last bit. For pictures and for derivatives; errors are judged by lateral_at().
double curve_at(const Boundary& boundary, double x);

/// Slope and second derivative of that line at x [m], taken over a few points.
struct CurveShape {
  double slope = 0;
  double bend = 0;  ///< d2y/dx2 [1/m]
};
CurveShape shape_at(const Boundary& boundary, double x);

}  // namespace lanefuse
