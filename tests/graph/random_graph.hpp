// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <random>

#include "graph/pose_graph.hpp"

namespace lanefuse::testing {

/// What a made-up graph is like: a winding drive whose poses see landmarks, some of which are tied to each
/// other.
struct GraphShape {
  unsigned seed = 1;
  std::size_t poses = 8;
  std::size_t landmarks = 12;
  std::size_t ties = 6;      ///< edges between landmarks; they tell nothing about x, as smoothing edges do
  std::size_t loops = 3;     ///< edges between poses that are far apart in the drive
  double noise = 0;          ///< of measurements [m], a tenth of it in rad
  double start_error = 0.1;  ///< of the start of all but the fixed vertex [m], a tenth of it in rad
};

class GraphMaker {
 public:
  explicit GraphMaker(const GraphShape& shape) : shape_(shape), random_(shape.seed) {}

  /// The last pose is fixed, at its true place.
  PoseGraph make() {
    PoseGraph graph;
    add_vertices(graph);
    for (VertexId p = 0; p + 1 < shape_.poses; ++p) add_edge(graph, p, p + 1, full_information());
    for (std::size_t i = 0; i < shape_.landmarks; ++i)
      add_sightings(graph, static_cast<VertexId>(shape_.poses + i));
    for (std::size_t i = 0; i < shape_.ties && shape_.landmarks > 1; ++i) {
      add_between(graph, shape_.poses, shape_.landmarks, tie_information());
    }
    for (std::size_t i = 0; i < shape_.loops && shape_.poses > 1; ++i) {
      add_between(graph, 0, shape_.poses, full_information());
    }
    return graph;
  }

  [[nodiscard]] const std::vector<Pose2>& truth() const { return truth_; }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }

 private:
  std::size_t below(std::size_t end) { return random_() % end; }

  Pose2 shaken(const Pose2& pose, double size) {
    return {pose.x + uniform(-size, size), pose.y + uniform(-size, size),
            wrap_angle(pose.heading + uniform(-size, size) / 10)};
  }

  void add_vertices(PoseGraph& graph) {
    Pose2 pose{uniform(-50, 50), uniform(-50, 50), uniform(-3, 3)};
    for (std::size_t p = 0; p < shape_.poses; ++p) {
      add_vertex(graph, pose, VertexRole::pose, p + 1 == shape_.poses);
      pose = pose * Pose2{uniform(1, 3), 0, uniform(-0.6, 0.6)};
    }
    for (std::size_t i = 0; i < shape_.landmarks; ++i) {
      const Pose2 seen{uniform(-5, 30), uniform(-8, 8), uniform(-3, 3)};
      add_vertex(graph, truth_[below(shape_.poses)] * seen, VertexRole::landmark, false);
    }
  }

  void add_vertex(PoseGraph& graph, const Pose2& pose, VertexRole role, bool fixed) {
    truth_.push_back({pose.x, pose.y, wrap_angle(pose.heading)});
    graph.vertices.push_back({fixed ? truth_.back() : shaken(pose, shape_.start_error), role, fixed});
  }

  /// A landmark is seen from some poses, now and then twice from one; now and then the edge points the other
  /// way.
  void add_sightings(PoseGraph& graph, VertexId landmark) {
    const std::size_t count = 1 + below(5);
    for (std::size_t i = 0; i < count; ++i) {
      const auto pose = static_cast<VertexId>(below(shape_.poses));
      if (below(4) == 0) {
        add_edge(graph, landmark, pose, full_information());
      } else {
        add_edge(graph, pose, landmark, full_information());
      }
    }
  }

  void add_between(PoseGraph& graph, std::size_t first, std::size_t count,
                   const Eigen::Matrix3d& information) {
    const auto from = static_cast<VertexId>(first + below(count));
    const auto to = static_cast<VertexId>(first + below(count));
    if (from != to) add_edge(graph, from, to, information);
  }

  void add_edge(PoseGraph& graph, VertexId from, VertexId to, const Eigen::Matrix3d& information) {
    graph.edges.push_back(
        {from, to, shaken(truth_[from].inverse() * truth_[to], shape_.noise), information, kNoSwitch});
  }

  Eigen::Matrix3d full_information() {
    Eigen::Matrix3d root;
    for (int i = 0; i < 9; ++i) root(i / 3, i % 3) = uniform(-3, 3);
    return root * root.transpose() + Eigen::Vector3d(5, 20, 400).asDiagonal().toDenseMatrix();
  }

  Eigen::Matrix3d tie_information() { return Eigen::Vector3d(0, 100, uniform(100, 2500)).asDiagonal(); }

  GraphShape shape_;
  std::mt19937 random_;
  std::vector<Pose2> truth_;
};

}  // namespace lanefuse::testing
