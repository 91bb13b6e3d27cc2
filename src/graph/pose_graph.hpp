// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/pose2.hpp"

namespace lanefuse {

using VertexId = std::uint32_t;
inline constexpr std::uint32_t kNoSwitch = 0xffffffff;

/// What role a vertex plays for the solver. A `landmark` is eliminated onto the poses before they are solved
/// for; that is an ordering hint, not a restriction: edges between landmarks are as good as any other.
enum class VertexRole : std::uint8_t { pose = 0, landmark = 1 };

struct Vertex {
  Pose2 pose;
  VertexRole role = VertexRole::pose;
  bool fixed = false;  ///< held where it is: at least one must be, the gauge
};

/// A constraint z_ij between two vertices with information Omega_ij [IROS16, eq. 3]. The error is the
/// difference z^-1 * (v_from^-1 * v_to), expressed in the measurement's frame as in g2o's EdgeSE2, with its
/// angle wrapped.
struct Edge {
  VertexId from = 0;
  VertexId to = 0;
  Pose2 measurement;                                          ///< z_ij: `to` seen from `from`
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< symmetric positive semi-definite
  /// Index into PoseGraph::switches, or kNoSwitch for an edge that is always on.
  std::uint32_t switch_index = kNoSwitch;
};

/// A switch variable s in [0, 1] that multiplies its edge's term, with the prior Omega_s (1 - s)^2 [IROS16,
/// sec. II-E4].
struct Switch {
  double prior = 1;  ///< Omega_s > 0
  double value = 1;  ///< s: 1 on, 0 off; written by the solver
};

/// How a switch variable enters the cost.
enum class SwitchForm : std::uint8_t {
  linear = 0,   ///< s J + W (1-s)^2, the paper's text; s = clip(1 - J / 2W, 0, 1)
  squared = 1,  ///< s^2 J + W (1-s)^2, Suenderhauf & Protzel 2012; s = W / (W + J)
};

/// Any planar pose graph: knows nothing of lanes.
struct PoseGraph {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Switch> switches;
};

/// e(z_ij, v_i, v_j) of an edge.
Eigen::Vector3d error(const Edge& edge, const Pose2& from, const Pose2& to);

/// The error with its Jacobians by (x, y, heading) of both ends.
struct Linearization {
  Eigen::Vector3d error;
  Eigen::Matrix3d from_jacobian;
  Eigen::Matrix3d to_jacobian;
};
Linearization linearize(const Edge& edge, const Pose2& from, const Pose2& to);

/// J(V) of [IROS16, eq. 3], with the switched terms and their priors at the switches' present values: the sum
/// of e' Omega e, without a factor 1/2. Edges that share a switch are switched together.
double chi_squared(const PoseGraph& graph, SwitchForm form = SwitchForm::linear);

}  // namespace lanefuse
