// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace lanefuse {

/// How a line of the road lies across it: a lateral place [m] as a smooth function of the station, cubic
/// between knots with given slopes, and constant before the first knot and after the last.
class LateralCourse {
 public:
  struct Knot {
    double station = 0;  ///< [m]
    double lateral = 0;  ///< [m], positive to the left
    double slope = 0;    ///< d lateral / d station
  };

  /// The same place all along.
  explicit LateralCourse(double lateral);
  /// `knots` in order of their stations, at least one; no two of one station.
  explicit LateralCourse(std::vector<Knot> knots);

  [[nodiscard]] double at(double station) const;
  [[nodiscard]] double slope(double station) const;

  /// Lets the course swing to `lateral` between two stations, smoothly and without a slope at either end.
  /// Whatever the course was after `from` is forgotten.
  void swing(double from, double to, double lateral);

 private:
  std::vector<Knot> knots_;
};

}  // namespace lanefuse
