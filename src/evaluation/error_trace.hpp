// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

namespace lanefuse {

/// Where on the way how large the error was: one entry a judged cycle, for the picture of a whole drive.
struct ErrorAtPlace {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the car in the world
  /// [m] the larger magnitude of the ego boundaries' deviations at kTraceDistanceIndex; NaN where neither
  /// reached.
  double error = 0;
};
inline constexpr std::size_t kTraceDistanceIndex = 6;  ///< 60 m

using ErrorTrace = std::vector<ErrorAtPlace>;

}  // namespace lanefuse
