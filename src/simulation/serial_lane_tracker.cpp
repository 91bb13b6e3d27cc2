// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/serial_lane_tracker.hpp"

#include <cmath>

namespace lanefuse {
namespace {

using Row5 = Eigen::Matrix<double, 1, 5>;
using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

/// Process noise, sigmas a square root of a metre driven: how fast roads change, and how far the odometry
/// errs.
const Vector5 kProcess(0.01, 0.7e-3, 3e-5, 3e-6, 0.003);
constexpr double kEdgeNoise = 0.03;  ///< [m] of a painted edge itself
constexpr double kGate = 9;          ///< squared; points further off are another edge
constexpr double kUsualWidth = 3.5;  ///< [m]

double sign(Side side) { return side == Side::left ? 1 : -1; }

Row5 point_jacobian(double x, Side side) { return {1, x, x * x / 2, x * x * x / 6, sign(side) / 2}; }

}  // namespace

SerialLaneTracker::State SerialLaneTracker::first_guess() {
  State guess;
  guess.mean << 0, 0, 0, 0, kUsualWidth;
  guess.covariance = Vector5(1, 0.05, 1e-3, 2e-5, 0.3).array().square().matrix().asDiagonal();
  return guess;
}

void SerialLaneTracker::predict(double seconds, double speed, double yaw_rate) {
  const double way = speed * seconds;
  const double turn = yaw_rate * seconds;
  Matrix5 transition = Matrix5::Identity();
  transition.row(0) << 1, way, way * way / 2, way * way * way / 6, 0;
  transition.row(1) << 0, 1, way, way * way / 2, 0;
  transition.row(2) << 0, 0, 1, way, 0;
  const Matrix5 process_noise = (kProcess.array().square() * std::abs(way)).matrix().asDiagonal();
  lanefuse::predict<5>(state_, transition, process_noise);
  state_.mean[0] -= turn * way / 2;
  state_.mean[1] -= turn;
}

void SerialLaneTracker::cross(int direction) {
  state_.mean[0] += direction * state_.mean[4];
  state_.covariance(0, 0) += 0.1 * 0.1;
  state_.covariance(4, 4) += 0.1 * 0.1;
}

void SerialLaneTracker::update(const std::vector<Point>& points) {
  using Scalar = Eigen::Matrix<double, 1, 1>;
  for (const Point& point : points) {
    const double x = point.place.x();
    const Row5 jacobian = point_jacobian(x, point.side);
    const double sigma = std::hypot(column_noise_ * x, kEdgeNoise);
    const Scalar residual(point.place.y() - jacobian.dot(state_.mean));
    const Scalar noise(sigma * sigma);
    const auto surprise = innovation<5, 1>(state_, residual, jacobian, noise);
    if (settled() && surprise.distance_squared() > kGate) continue;
    lanefuse::update<5, 1>(state_, residual, jacobian, noise);
  }
  if (!points.empty()) ++frames_;
}

ClothoidMeasurement SerialLaneTracker::boundary(Side side) const {
  Eigen::Matrix<double, 4, 5> boundary_from_lane = Eigen::Matrix<double, 4, 5>::Zero();
  boundary_from_lane.leftCols<4>().setIdentity();
  boundary_from_lane(0, 4) = sign(side) / 2;
  ClothoidMeasurement measurement;
  measurement.clothoid = Clothoid::from_vector(boundary_from_lane * state_.mean);
  const Eigen::Matrix4d covariance = boundary_from_lane * state_.covariance * boundary_from_lane.transpose();
  measurement.covariance = (covariance + covariance.transpose()) / 2;
  measurement.side = side;
  return measurement;
}

}  // namespace lanefuse
