// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/feature.hpp"
#include "core/kalman.hpp"

namespace lanefuse {

/// The lane tracker inside the simulated serial camera: a Kalman filter over the ego lane's offset, heading,
/// curvature, curvature rate and width, as production cameras run. It is part of the sensor, belongs to the
/// simulator alone, and never changes: results would no longer compare. It lags and correlates its errors as
/// real ones do, and believes too much in itself: it takes the points of a frame as independent, which they
/// are not (pitch, yaw, vertical curvature).
class SerialLaneTracker {
 public:
  struct Point {
    Eigen::Vector2d place;  ///< vehicle frame, on the inner edge of a marking
    Side side = Side::none;
  };

  /// `column_noise` [rad]: sigma of a point's image column, the one error that it knows of.
  explicit SerialLaneTracker(double column_noise) : column_noise_(column_noise) {}

  /// Moves the lane with the car, over `seconds` of this speed [m/s] and yaw rate [rad/s].
  void predict(double seconds, double speed, double yaw_rate);
  /// The car has crossed into the next lane on the left (+1) or right (-1).
  void cross(int direction);
  void update(const std::vector<Point>& points);

  /// Whether it has seen enough to speak.
  [[nodiscard]] bool settled() const { return frames_ >= kFramesToSettle; }
  /// Clothoid and covariance of one side's inner edge; the ranges are the camera's to fill in.
  [[nodiscard]] ClothoidMeasurement boundary(Side side) const;

 private:
  static constexpr int kFramesToSettle = 5;
  using State = Gaussian<5>;  ///< (offset of the lane's middle, heading, curvature, curvature rate, width)

  double column_noise_;
  State state_ = first_guess();
  int frames_ = 0;

  static State first_guess();
};

}  // namespace lanefuse
