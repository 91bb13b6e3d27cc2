// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Lesson 3: a pose graph without lanes. A robot drives twice around a square of 4 m, sees in the second lap
// where it has been, and is wrong about it once. A switch on every loop closure lets the graph disbelieve
// that one.
#include <cmath>
#include <cstdio>
#include <lanefuse/graph/pose_graph.hpp>
#include <lanefuse/graph/solver.hpp>

namespace {

constexpr lanefuse::VertexId kPoses = 32;  // a metre apart, 16 a lap

Eigen::Matrix3d information(double sigma, double heading_sigma) {
  const double position = 1 / (sigma * sigma);
  return Eigen::Vector3d(position, position, 1 / (heading_sigma * heading_sigma)).asDiagonal();
}

/// Odometry says a metre, and a left turn at each corner, of which it misses a third of a degree.
lanefuse::Pose2 step(lanefuse::VertexId from) {
  const double turn = from % 4 == 3 ? std::acos(0.0) - 0.006 : 0;
  return {1, 0, turn};
}

lanefuse::PoseGraph make_graph() {
  lanefuse::PoseGraph graph;
  graph.vertices.push_back({{0, 0, 0}, lanefuse::VertexRole::pose, true});  // the gauge
  for (lanefuse::VertexId i = 0; i + 1 < kPoses; ++i) {
    graph.vertices.push_back({graph.vertices.back().pose * step(i)});
    graph.edges.push_back({i, i + 1, step(i), information(0.05, 0.03)});
  }
  const auto close_loop = [&graph](lanefuse::VertexId from, lanefuse::VertexId to) {
    const auto its_switch = static_cast<std::uint32_t>(graph.switches.size());
    graph.switches.push_back({});
    graph.edges.push_back({from, to, {0, 0, 0}, information(0.05, 0.03), its_switch});
  };
  for (lanefuse::VertexId i = 0; i < 16; i += 4) close_loop(i, i + 16);
  close_loop(2, 26);  // the opposite side of the square: false
  return graph;
}

}  // namespace

int main() {
  lanefuse::PoseGraph graph = make_graph();
  lanefuse::SolverConfig config;
  config.max_iterations = 50;
  config.switch_form = lanefuse::SwitchForm::squared;
  const lanefuse::SolveResult result = lanefuse::make_schur_solver()->solve(graph, config);
  std::printf("%s after %d iterations, chi2 %.3f -> %.3f\n", lanefuse::to_string(result.status),
              result.iterations, result.initial_chi2, result.final_chi2);
  for (const lanefuse::Edge& edge : graph.edges) {
    if (edge.switch_index == lanefuse::kNoSwitch) continue;
    std::printf("loop %u - %u: %.3f\n", edge.from, edge.to, graph.switches[edge.switch_index].value);
  }
  const lanefuse::Pose2& corner = graph.vertices[8].pose;
  std::printf("the far corner: %.2f %.2f\n", corner.x, corner.y);
  return result.ok() ? 0 : 1;
}
