// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace lanefuse {

/// A straight piece of something that may be paint.
struct LinePiece {
  double x = 0;        ///< [m] its middle
  double y = 0;        ///< [m]
  double slope = 0;    ///< dy/dx
  double y_sigma = 0;  ///< [m]
  double slope_sigma = 0;
  double length = 0;  ///< [m] of paint: how much it counts
};

struct ParallelLinesConfig {
  double heading_sigma = 0.04;         ///< [rad] of the road against the car
  double curvature_sigma = 1.0 / 800;  ///< [1/m]
  double curvature_rate_sigma = 2e-5;  ///< [1/m^2]
  double line_spacing = 0.35;          ///< [m] lines nearer to each other are one
};

/// The lines of a motorway run side by side: one shape and an offset each fit all of them, and with the right
/// pitch of the camera they do not fan out. What does not fit is no line, or not one of this road.
///
///     y = f (o + theta x + c0 x^2/2 + c1 x^3/6),  f = 1 + p x
///
/// where p is what a wrong pitch does: it stretches what is far.
class ParallelLines {
 public:
  explicit ParallelLines(const ParallelLinesConfig& config) : config_(config) {}

  /// `stretch_sigma` [1/m]: of p, as the pose's pitch is uncertain.
  void fit(std::span<const LinePiece> pieces, double stretch_sigma);

  struct Line {
    double offset = 0;    ///< [m]
    double length = 0;    ///< [m] of paint that bears witness to it
    double nearest = 0;   ///< [m]
    double farthest = 0;  ///< [m]
  };
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

  /// The offset of the line through (x, y), and the slope that it has there.
  [[nodiscard]] double offset(double x, double y) const;
  [[nodiscard]] double slope(double x, double y) const;
  /// The line nearest to an offset, or nullptr where none is within `reach` [m].
  [[nodiscard]] const Line* nearest(double offset, double reach) const;
  [[nodiscard]] double stretch() const { return shape_[3]; }

 private:
  ParallelLinesConfig config_;
  Eigen::Vector4d shape_ = Eigen::Vector4d::Zero();  ///< theta, c0, c1, p
  std::vector<Line> lines_;
  std::vector<std::size_t> order_;
  std::vector<double> offsets_;

  [[nodiscard]] double course(double x) const;
  void fit_slopes(std::span<const LinePiece> pieces, double range, double doubt,
                  const Eigen::Vector4d& prior);
  void gather(std::span<const LinePiece> pieces, double range);
  void fit_places(std::span<const LinePiece> pieces, double range, const Eigen::Vector4d& prior);
};

}  // namespace lanefuse
