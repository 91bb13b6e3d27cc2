// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/pose_graph.hpp"

#include "graph/switchable.hpp"

namespace lanefuse {

Eigen::Vector3d error(const Edge& edge, const Pose2& from, const Pose2& to) {
  const Eigen::Matrix2d from_rotation = rotation(from.heading);
  const Eigen::Vector2d seen = from_rotation.transpose() * (to.position() - from.position());
  const Eigen::Vector2d difference =
      rotation(edge.measurement.heading).transpose() * (seen - edge.measurement.position());
  return {difference.x(), difference.y(), wrap_angle(to.heading - from.heading - edge.measurement.heading)};
}

Linearization linearize(const Edge& edge, const Pose2& from, const Pose2& to) {
  // The positional error is R' (t_to - t_from) less a constant, with R = R(heading of from + heading of z).
  const Eigen::Matrix2d turn = rotation(from.heading + edge.measurement.heading).transpose();
  const Eigen::Vector2d apart = to.position() - from.position();
  const Eigen::Vector2d across(-apart.y(), apart.x());
  Linearization result{error(edge, from, to), -Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()};
  result.from_jacobian.topLeftCorner<2, 2>() = -turn;
  result.from_jacobian.topRightCorner<2, 1>() = -turn * across;
  result.to_jacobian.topLeftCorner<2, 2>() = turn;
  return result;
}

double chi_squared(const PoseGraph& graph, SwitchForm form) {
  double sum = 0;
  for (const Edge& edge : graph.edges) {
    const Eigen::Vector3d e = error(edge, graph.vertices[edge.from].pose, graph.vertices[edge.to].pose);
    const double cost = e.dot(edge.information * e);
    sum += edge.switch_index == kNoSwitch
               ? cost
               : switch_factor(form, graph.switches[edge.switch_index].value) * cost;
  }
  for (const Switch& s : graph.switches) sum += s.prior * (1 - s.value) * (1 - s.value);
  return sum;
}

}  // namespace lanefuse
