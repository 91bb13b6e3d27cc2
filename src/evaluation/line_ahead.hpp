// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace lanefuse {

/// A line of truth around the car, as a polyline in the vehicle frame that only goes forward.
class LineAhead {
 public:
  static constexpr double kSmallestStep = 0.05;  ///< [m] along x

  /// Appends a point if it lies at least kSmallestStep further forward than the last one; else the line does
  /// not change. So neither a car that stands still nor noise along the line makes kinks.
  void extend(const Eigen::Vector2d& point);
  void clear() { points_.clear(); }

  /// Where the line crosses x, or nothing before its begin and behind its end.
  [[nodiscard]] std::optional<double> y(double x) const;

  /// How far left of the line `point` lies, measured across the line [m]; beyond an end its last segment is
  /// prolonged. Needs a line that has y(x) somewhere.
  [[nodiscard]] double deviation(const Eigen::Vector2d& point) const;

  /// In the order of increasing x.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& points() const { return points_; }

 private:
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace lanefuse
