// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/loss_function.h>
#include <ceres/sized_cost_function.h>

#include "graph/pose_graph.hpp"

namespace lanefuse {

/// An edge as Ceres wants it: the error of g2o's EdgeSE2 under the root of its information, with analytic
/// Jacobians. Kept in the frame of `from`, where e' Omega e is the same and costs less.
class CeresEdge final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit CeresEdge(const Edge& edge);
  bool Evaluate(const double* const* poses, double* residuals, double** jacobians) const override;

 private:
  Pose2 measurement_;
  Eigen::Matrix3d root_;  ///< root' root = Omega, in the frame of `from`
};

/// The switch of an edge, eliminated: min over s of s J + W (1-s)^2, or of s^2 J + W (1-s)^2.
class CeresSwitch final : public ceres::LossFunction {
 public:
  CeresSwitch(SwitchForm form, double prior) : form_(form), prior_(prior) {}
  /// rho(J) and its first two derivatives.
  void Evaluate(double cost, double rho[3]) const override;

 private:
  SwitchForm form_;
  double prior_;
};

}  // namespace lanefuse
