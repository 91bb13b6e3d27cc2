// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "peers/ceres_problem.hpp"

#include <algorithm>
#include <tuple>

#include "core/error.hpp"
#include "graph/switchable.hpp"
#include "peers/ceres_edge.hpp"

namespace lanefuse {

namespace {

bool same(const Edge& a, const Edge& b) {
  return std::tie(a.from, a.to, a.switch_index, a.measurement) ==
             std::tie(b.from, b.to, b.switch_index, b.measurement) &&
         a.information == b.information;
}

bool same(const Vertex& a, const Vertex& b) { return a.fixed == b.fixed && a.role == b.role; }

bool same(const Switch& a, const Switch& b) { return a.prior == b.prior; }

template <typename Thing>
bool all_same(const std::vector<Thing>& a, const std::vector<Thing>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Thing& x, const Thing& y) { return same(x, y); });
}

void refuse_shared_switches(const PoseGraph& graph) {
  std::vector<bool> used(graph.switches.size(), false);
  for (const Edge& edge : graph.edges) {
    if (edge.switch_index == kNoSwitch) continue;
    if (used[edge.switch_index]) {
      throw configuration_error("solver ceres", "takes no switch that two edges share",
                                "give each edge a switch of its own, or choose another solver");
    }
    used[edge.switch_index] = true;
  }
}

}  // namespace

CeresProblem::CeresProblem(const PoseGraph& graph, SwitchForm form) : graph_(graph), form_(form) {
  refuse_shared_switches(graph);
  ceres::Problem::Options options;
  options.disable_all_safety_checks = true;  // find_fault() has looked
  problem_ = std::make_unique<ceres::Problem>(options);
  read_places(graph);
  add_edges(form);
  hold_and_group();
}

void CeresProblem::add_edges(SwitchForm form) {
  for (const Edge& edge : graph_.edges) {
    ceres::LossFunction* loss = nullptr;
    if (edge.switch_index != kNoSwitch) {
      loss = std::make_unique<CeresSwitch>(form, graph_.switches[edge.switch_index].prior).release();
    }
    problem_->AddResidualBlock(std::make_unique<CeresEdge>(edge).release(), loss, places_[edge.from].data(),
                               places_[edge.to].data());
  }
}

void CeresProblem::hold_and_group() {
  std::vector<std::vector<VertexId>> ties(graph_.vertices.size());
  for (const Edge& edge : graph_.edges) {
    ties[edge.from].push_back(edge.to);
    ties[edge.to].push_back(edge.from);
  }
  std::vector<bool> first(graph_.vertices.size(), false);
  for (VertexId v = 0; v < graph_.vertices.size(); ++v) {
    double* place = places_[v].data();
    if (!problem_->HasParameterBlock(place)) continue;
    if (graph_.vertices[v].fixed) {
      problem_->SetParameterBlockConstant(place);
      continue;
    }
    first[v] = graph_.vertices[v].role == VertexRole::landmark &&
               std::none_of(ties[v].begin(), ties[v].end(), [&](VertexId other) { return first[other]; });
    groups_[first[v] ? 0 : 1].push_back(place);
  }
}

bool CeresProblem::fits(const PoseGraph& graph, SwitchForm form) const {
  return form == form_ && all_same(graph.edges, graph_.edges) && all_same(graph.switches, graph_.switches) &&
         all_same(graph.vertices, graph_.vertices);
}

void CeresProblem::read_places(const PoseGraph& graph) {
  places_.resize(graph.vertices.size());
  for (std::size_t v = 0; v < places_.size(); ++v) {
    const Pose2& pose = graph.vertices[v].pose;
    places_[v] = {pose.x, pose.y, pose.heading};
  }
}

void CeresProblem::write_places(PoseGraph& graph) const {
  for (std::size_t v = 0; v < places_.size(); ++v) {
    if (graph.vertices[v].fixed) continue;
    graph.vertices[v].pose = {places_[v][0], places_[v][1], wrap_angle(places_[v][2])};
  }
  for (const Edge& edge : graph.edges) {
    if (edge.switch_index == kNoSwitch) continue;
    const Eigen::Vector3d e = error(edge, graph.vertices[edge.from].pose, graph.vertices[edge.to].pose);
    Switch& s = graph.switches[edge.switch_index];
    s.value = best_switch(form_, e.dot(edge.information * e), s.prior);
  }
}

}  // namespace lanefuse
