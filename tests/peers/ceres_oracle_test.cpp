// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// An independent judge: Ceres minimises the same cost from the same start by its own means.
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include "graph/loops.hpp"
#include "graph/random_graph.hpp"
#include "graph/solver.hpp"

namespace lanefuse {
namespace {

using testing::GraphMaker;
using testing::GraphShape;

/// z^-1 * (from^-1 * to), weighted with the root of the information; automatically differentiated.
struct EdgeResidual {
  Pose2 z;
  Eigen::Matrix3d root;

  template <typename T>
  bool operator()(const T* from, const T* to, T* residual) const {
    const T c = cos(from[2] + z.heading), s = sin(from[2] + z.heading);
    const T dx = to[0] - from[0], dy = to[1] - from[1];
    const T turn = to[2] - from[2] - z.heading;
    Eigen::Matrix<T, 3, 1> e;
    e << c * dx + s * dy - (std::cos(z.heading) * z.x + std::sin(z.heading) * z.y),
        c * dy - s * dx - (std::cos(z.heading) * z.y - std::sin(z.heading) * z.x),
        atan2(sin(turn), cos(turn));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> result(residual);
    result = root.cast<T>() * e;
    return true;
  }
};

/// min over s of s J + W (1-s)^2, or of s^2 J + W (1-s)^2, with its first two derivatives by J.
class SwitchLoss final : public ceres::LossFunction {
 public:
  SwitchLoss(SwitchForm form, double prior) : form_(form), w_(prior) {}
  void Evaluate(double j, double out[3]) const override {
    if (form_ == SwitchForm::squared) {
      const double s = w_ / (w_ + j);
      out[0] = s * j, out[1] = s * s, out[2] = -2 * s * s / (w_ + j);
    } else if (j < 2 * w_) {
      out[0] = j - j * j / (4 * w_), out[1] = 1 - j / (2 * w_), out[2] = -1 / (2 * w_);
    } else {
      out[0] = w_, out[1] = 0, out[2] = 0;
    }
  }

 private:
  SwitchForm form_;
  double w_;
};

/// R with R' R = information, which may be singular.
Eigen::Matrix3d root_of(const Eigen::Matrix3d& information) {
  const Eigen::LDLT<Eigen::Matrix3d> factor(information);
  const Eigen::Vector3d roots = factor.vectorD().cwiseMax(0).cwiseSqrt();
  const Eigen::Matrix3d upper = factor.matrixU();
  return roots.asDiagonal() * upper * Eigen::Matrix3d(factor.transpositionsP() * Eigen::Matrix3d::Identity());
}

double ceres_chi2(const PoseGraph& graph, SwitchForm form) {
  std::vector<std::array<double, 3>> poses;
  for (const Vertex& v : graph.vertices) poses.push_back({v.pose.x, v.pose.y, v.pose.heading});
  ceres::Problem problem;
  for (const Edge& edge : graph.edges) {
    auto* cost = new ceres::AutoDiffCostFunction<EdgeResidual, 3, 3, 3>(
        new EdgeResidual{edge.measurement, root_of(edge.information)});
    ceres::LossFunction* loss = edge.switch_index == kNoSwitch
                                    ? nullptr
                                    : new SwitchLoss(form, graph.switches[edge.switch_index].prior);
    problem.AddResidualBlock(cost, loss, poses[edge.from].data(), poses[edge.to].data());
  }
  for (std::size_t v = 0; v < poses.size(); ++v) {
    if (graph.vertices[v].fixed) problem.SetParameterBlockConstant(poses[v].data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 500;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  EXPECT_TRUE(summary.IsSolutionUsable()) << summary.BriefReport();
  return 2 * summary.final_cost;
}

void expect_same_chi2(PoseGraph graph, SwitchForm form) {
  const double expected = ceres_chi2(graph, form);
  SolverConfig config;
  config.max_iterations = 300;
  config.relative_tolerance = 1e-12;
  config.switch_form = form;
  const SolveResult result = make_schur_solver()->solve(graph, config);
  EXPECT_TRUE(result.ok());
  EXPECT_NEAR(result.final_chi2, expected, 1e-6 * expected);
}

TEST(CeresOracle, AgreesOnPosesLandmarksAndLadders) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const GraphShape shape{
        .seed = seed, .poses = 15, .landmarks = 25, .ties = 2 * seed, .loops = seed % 4, .noise = 0.2};
    expect_same_chi2(GraphMaker(shape).make(), SwitchForm::linear);
  }
}

TEST(CeresOracle, AgreesOnManyPoses) {
  expect_same_chi2(GraphMaker({.seed = 21, .poses = 230, .landmarks = 20, .noise = 0.1}).make(),
                   SwitchForm::linear);
}

TEST(CeresOracle, AgreesOnTheEliminatedSwitches) {
  for (const SwitchForm form : {SwitchForm::linear, SwitchForm::squared}) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(seed);
      PoseGraph graph =
          GraphMaker({.seed = seed, .poses = 20, .landmarks = 10, .loops = 10, .noise = 0.2}).make();
      make_loops_switchable(graph, 8);
      expect_same_chi2(graph, form);
    }
  }
}

}  // namespace
}  // namespace lanefuse
