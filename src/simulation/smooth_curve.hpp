// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace lanefuse {

/// A number that follows noisy samples smoothly: a cubic spline with uniform knots, fitted by least squares.
/// Value, slope and bend are continuous; beyond the samples it goes on straight.
class SmoothCurve {
 public:
  struct Sample {
    double at = 0;
    double value = 0;
  };
  struct Place {
    double value = 0;
    double slope = 0;  ///< first derivative
    double bend = 0;   ///< second derivative
  };

  /// `samples` in any order, at least one; knots about `spacing` apart. Fine structure between the knots is
  /// noise.
  SmoothCurve(std::span<const Sample> samples, double spacing);

  /// Raises and lowers the curve as little as needed for it never to fall.
  void make_rising();

  [[nodiscard]] Place at(double place) const;

 private:
  double begin_;
  double spacing_;
  Eigen::VectorXd knots_;  ///< coefficients, three more than there are intervals

  [[nodiscard]] double end() const { return begin_ + spacing_ * static_cast<double>(knots_.size() - 3); }
  [[nodiscard]] Place inside(double place) const;
};

}  // namespace lanefuse
