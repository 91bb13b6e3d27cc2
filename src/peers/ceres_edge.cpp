// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/ceres_edge.hpp"

#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {

namespace {

/// R with R' R = information, which may be singular.
Eigen::Matrix3d root_of(const Eigen::Matrix3d& information) {
  const Eigen::LDLT<Eigen::Matrix3d> factor(information);
  const Eigen::Vector3d roots = factor.vectorD().cwiseMax(0).cwiseSqrt();
  const Eigen::Matrix3d upper = factor.matrixU();
  return roots.asDiagonal() * upper * Eigen::Matrix3d(factor.transpositionsP() * Eigen::Matrix3d::Identity());
}

Eigen::Matrix3d turn_back(double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  return Eigen::Matrix3d{{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}

}  // namespace

CeresEdge::CeresEdge(const Edge& edge)
    : measurement_(edge.measurement),
      root_(root_of(edge.information) * turn_back(edge.measurement.heading)) {}

bool CeresEdge::Evaluate(const double* const* poses, double* residuals, double** jacobians) const {
  using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const double* from = poses[0];
  const double* to = poses[1];
  const double c = std::cos(from[2]), s = std::sin(from[2]);
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  const double ahead = c * dx + s * dy, left = c * dy - s * dx;
  const Eigen::Vector3d error(ahead - measurement_.x, left - measurement_.y,
                              wrap_angle(to[2] - from[2] - measurement_.heading));
  Eigen::Map<Eigen::Vector3d>{residuals} = root_ * error;
  if (!jacobians) return true;
  Eigen::Matrix3d by_to;
  by_to.leftCols<2>() = root_.leftCols<2>() * Eigen::Matrix2d{{c, s}, {-s, c}};
  by_to.col(2) = root_.col(2);
  if (jacobians[1]) Eigen::Map<RowMajor3>{jacobians[1]} = by_to;
  if (jacobians[0]) {
    Eigen::Map<RowMajor3> by_from(jacobians[0]);
    by_from.leftCols<2>() = -by_to.leftCols<2>();
    by_from.col(2) = root_.leftCols<2>() * Eigen::Vector2d(left, -ahead) - root_.col(2);
  }
  return true;
}

void CeresSwitch::Evaluate(double cost, double rho[3]) const {
  if (form_ == SwitchForm::squared) {
    const double s = prior_ / (prior_ + cost);
    rho[0] = s * cost, rho[1] = s * s, rho[2] = -2 * s * s / (prior_ + cost);
  } else if (cost < 2 * prior_) {
    rho[0] = cost - cost * cost / (4 * prior_), rho[1] = 1 - cost / (2 * prior_), rho[2] = -1 / (2 * prior_);
  } else {
    rho[0] = prior_, rho[1] = 0, rho[2] = 0;
  }
}

}  // namespace lanefuse
