// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "camera/road_sight.hpp"
#include "core/clothoid.hpp"
#include "core/feature.hpp"
#include "core/kalman.hpp"

namespace lanefuse {

/// What the lane tracker estimates: the lane in the vehicle frame and how this image looks at it.
struct LaneState {
  static constexpr int kOffset = 0;             ///< [m] of the lane's middle at x = 0, positive to the left
  static constexpr int kWidth = 1;              ///< [m] between the inner edges
  static constexpr int kHeading = 2;            ///< [rad]
  static constexpr int kCurvature = 3;          ///< [1/m]
  static constexpr int kCurvatureRate = 4;      ///< [1/m^2]
  static constexpr int kPitch = 5;              ///< [rad] on top of the pose's
  static constexpr int kVerticalCurvature = 6;  ///< [1/m]
  /// [rad] by which the car seems to drive past where it looks: what the pose's yaw is off, and slip.
  static constexpr int kDrift = 7;
  static constexpr int kSize = 8;
  using Vector = Eigen::Matrix<double, kSize, 1>;
  using RowVector = Eigen::Matrix<double, 1, kSize>;
  using Matrix = Eigen::Matrix<double, kSize, kSize>;

  /// The inner edge of one marking.
  static Clothoid edge(const Vector& state, Side side);
};

/// An edge's distance to where the state expects it, in pixels along its row.
struct EdgeResidual {
  double pixels = 0;              ///< found column minus expected column
  LaneState::RowVector jacobian;  ///< of the expected column
  double metres_per_pixel = 0;    ///< across the road, along the row
  double distance = 0;            ///< [m] along x
};
std::optional<EdgeResidual> edge_residual(const RoadSight& sight, const RoadSight::Ray& ray, Side side,
                                          const LaneState::Vector& state);

/// A found edge with the noise of its column.
struct EdgeMeasurement {
  RoadSight::Ray ray;
  Side side = Side::none;
  int window = 0;         ///< only one measurement a window counts: the likeliest
  double column = 0;      ///< [px]
  double row = 0;         ///< [px]
  double confidence = 1;  ///< weight in (0, 1]
};

struct LaneFilterConfig {
  double pixel_noise = 0.6;    ///< [px]
  double paint_noise = 0.015;  ///< [m]
  double gate = 3.2;           ///< [sigma]
  double pitch_sigma = 0.010;  ///< [rad]
  double pitch_tau = 0.4;      ///< [s]
  double vertical_curvature_sigma = 4e-5;
  double vertical_curvature_length = 100;  ///< [m]
  double width_walk = 0.10;                ///< [m] in 1 s
  double offset_walk = 0.10;               ///< [m] in 1 s
  double drift_walk = 0.003;               ///< [rad] in 1 s
  double heading_walk = 0.02;              ///< [rad] in 1 s
  double curvature_walk = 3e-4;            ///< [1/m] in 100 m, on top of the rate
  double curvature_rate_sigma = 1e-5;      ///< [1/m^2]
  double curvature_rate_length = 100;      ///< [m]
};

/// The iterated extended Kalman filter itself.
class LaneFilter {
 public:
  explicit LaneFilter(const LaneFilterConfig& config) : config_(config) {}

  [[nodiscard]] const Gaussian<LaneState::kSize>& state() const { return state_; }
  [[nodiscard]] Gaussian<LaneState::kSize>& state() { return state_; }

  /// Moves the lane by the car's motion: `seconds` with `speed` [m/s] and `yaw_rate` [rad/s].
  void predict(double seconds, double speed, double yaw_rate);

  /// The pose that is handed in has been corrected by so much [rad, rad, 1]; the picture has not changed.
  void correct_pose(double pitch, double yaw, double height_ratio);

  /// The car has crossed the marking of `side`, which is `marking_width` [m] wide: the lane beyond it is the
  /// ego lane now, as wide as the old one as far as is known.
  void cross_marking(Side side, double marking_width);

  /// Variance of an edge's column [px^2].
  [[nodiscard]] double noise(const EdgeResidual& residual) const;

  static constexpr std::size_t kMostEdges = 256;
  struct Fit {
    int inliers[2] = {0, 0};                ///< left, right
    double mean_square = 0;                 ///< of the inliers' residuals over their sigma
    std::array<bool, kMostEdges> inlier{};  ///< by measurement
  };
  /// Takes in what fits together of `edges` (at most kMostEdges), robustly, and corrects the state.
  void update(const RoadSight& sight, std::span<const EdgeMeasurement> edges, Fit& fit);

  /// The covariance of (y0, theta0, c0, c1) of one edge.
  [[nodiscard]] Eigen::Matrix4d edge_covariance(Side side) const;

 private:
  LaneFilterConfig config_;
  Gaussian<LaneState::kSize> state_;

  [[nodiscard]] LaneState::Vector best_start(const RoadSight& sight,
                                             std::span<const EdgeMeasurement> edges) const;
};

}  // namespace lanefuse
