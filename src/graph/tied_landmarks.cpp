// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/tied_landmarks.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/LU>

#include "graph/determinacy.hpp"
#include "graph/switchable.hpp"
#include "graph/window_algebra.hpp"

namespace lanefuse {

namespace {

constexpr std::uint32_t kNoNode = 0xffffffff;

}  // namespace

struct TiedLandmarks::TieError {
  PlanarTerm term;
  double cost = 0;  ///< with the switch's prior
  double switch_value = 1;
};

void TiedLandmarks::prepare(const WindowGraph& graph, WindowSystem& system) {
  order(graph, system);
  find_pattern(graph);
  find_ties(graph);
}

void TiedLandmarks::order(const WindowGraph& graph, WindowSystem& system) {
  untied_ = system.untied = system.runs.size();
  along_.clear();
  const Pose2 ahead = graph.pose(graph.chain().back());
  const double c = std::cos(ahead.heading);
  const double s = std::sin(ahead.heading);
  for (WindowGraph::Id id = 0; id < graph.landmark_slots(); ++id) {
    if (!graph.is_alive(id) || graph.first_tie(id) == WindowGraph::kNone) continue;
    const Pose2 pose = graph.landmark(id);
    along_.emplace_back(c * (pose.x - ahead.x) + s * (pose.y - ahead.y), id);
  }
  std::sort(along_.begin(), along_.end());
  node_of_.assign(graph.landmark_slots(), kNoNode);
  landmark_of_.clear();
  for (const auto& [way, id] : along_) {
    node_of_[id] = static_cast<std::uint32_t>(landmark_of_.size());
    landmark_of_.push_back(id);
    system.runs.push_back({id, 0, 0});
  }
}

/// Each column's rows are its own ties to later nodes and what its children in the elimination tree leave.
void TiedLandmarks::find_pattern(const WindowGraph& graph) {
  const auto nodes = static_cast<std::uint32_t>(landmark_of_.size());
  begin_.assign(1, 0);
  rows_.clear();
  first_child_.assign(nodes, kNoNode);
  next_sibling_.assign(nodes, kNoNode);
  mark_.assign(nodes, kNoNode);
  for (std::uint32_t k = 0; k < nodes; ++k) {
    const auto take = [&](std::uint32_t row) {
      if (row <= k || mark_[row] == k) return;
      mark_[row] = k;
      rows_.push_back(row);
    };
    const WindowGraph::Id own = landmark_of_[k];
    for (WindowGraph::Id id = graph.first_tie(own); id != WindowGraph::kNone;) {
      const WindowGraph::Tie& tie = graph.tie(id);
      take(node_of_[tie.from == own ? tie.to : tie.from]);
      id = graph.next_tie(tie, own);
    }
    for (std::uint32_t child = first_child_[k]; child != kNoNode; child = next_sibling_[child]) {
      for (std::uint32_t i = begin_[child]; i < begin_[child + 1]; ++i) {
        const std::uint32_t row = rows_[i];
        take(row);
      }
    }
    const auto first = rows_.begin() + begin_[k];
    std::sort(first, rows_.end());
    begin_.push_back(static_cast<std::uint32_t>(rows_.size()));
    if (begin_[k] == begin_[k + 1]) continue;
    const std::uint32_t parent = rows_[begin_[k]];
    next_sibling_[k] = first_child_[parent];
    first_child_[parent] = k;
  }
}

void TiedLandmarks::find_ties(const WindowGraph& graph) {
  active_.clear();
  for (WindowGraph::Id id = 0; id < graph.tie_slots(); ++id) {
    if (!graph.is_tie(id)) continue;
    const std::uint32_t from = node_of_[graph.tie(id).from];
    const std::uint32_t to = node_of_[graph.tie(id).to];
    active_.push_back({id, from, to, find_block(std::min(from, to), std::max(from, to))});
  }
  switch_values_.assign(active_.size(), 1);
  diagonal_.resize(landmark_of_.size());
  inverse_.resize(landmark_of_.size());
  scale_.resize(landmark_of_.size());
  off_diagonal_.resize(rows_.size());
}

std::uint32_t TiedLandmarks::find_block(std::uint32_t column, std::uint32_t row) const {
  std::uint32_t i = begin_[column];
  while (rows_[i] != row) ++i;
  assert(i < begin_[column + 1]);
  return i;
}

TiedLandmarks::TieError TiedLandmarks::error(const WindowGraph& graph, const Active& active, SwitchForm form,
                                             const WindowSystem& system) const {
  const WindowGraph::Tie& tie = graph.tie(active.tie);
  TieError result;
  result.term = planar_term(tie.measurement, tie.information, system.landmarks[untied_ + active.from],
                            system.landmarks[untied_ + active.to]);
  result.cost = result.term.cost;
  if (tie.switch_prior <= 0) return result;
  result.switch_value = best_switch(form, result.term.cost, tie.switch_prior);
  result.cost = switched_cost(form, result.term.cost, tie.switch_prior);
  const double factor = switch_factor(form, result.switch_value);
  result.term.information *= factor;
  result.term.force *= factor;
  return result;
}

double TiedLandmarks::linearize(const WindowGraph& graph, SwitchForm form, WindowSystem& system) {
  for (std::size_t k = 0; k < diagonal_.size(); ++k) {
    const Quad& i = system.information[untied_ + k];
    diagonal_[k] << i[0], i[1], 0, i[1], i[2], 0, 0, 0, i[3];
  }
  for (Eigen::Matrix3d& block : off_diagonal_) block.setZero();
  double cost = 0;
  for (std::size_t a = 0; a < active_.size(); ++a) {
    const Active& active = active_[a];
    const TieError tie = error(graph, active, form, system);
    cost += tie.cost;
    switch_values_[a] = tie.switch_value;
    const PlanarBlocks blocks = planar_blocks(tie.term);
    diagonal_[active.from] += blocks.from_from;
    diagonal_[active.to] += tie.term.information;
    if (active.from < active.to) {
      off_diagonal_[active.block] += blocks.from_to;
    } else {
      off_diagonal_[active.block] += blocks.from_to.transpose();
    }
    add(system.landmark_rhs[untied_ + active.from], blocks.from_rhs);
    add(system.landmark_rhs[untied_ + active.to], -tie.term.force);
  }
  return cost;
}

double TiedLandmarks::cost(const WindowGraph& graph, SwitchForm form, const WindowSystem& system) {
  double cost = 0;
  for (std::size_t a = 0; a < active_.size(); ++a) {
    const TieError tie = error(graph, active_[a], form, system);
    cost += tie.cost;
    switch_values_[a] = tie.switch_value;
  }
  return cost;
}

bool TiedLandmarks::factorise() {
  const auto nodes = static_cast<std::uint32_t>(diagonal_.size());
  for (std::uint32_t k = 0; k < nodes; ++k) scale_[k] = diagonal_[k].diagonal();
  for (std::uint32_t k = 0; k < nodes; ++k) {
    if (!is_determined(diagonal_[k], scale_[k])) return false;
    inverse_[k] = diagonal_[k].inverse();
    eliminate(k);
  }
  return true;
}

/// Takes node k out of the later ones it is tied to. Its rows are among those of its first row, and so on:
/// one walk down each of their columns finds the blocks.
void TiedLandmarks::eliminate(std::uint32_t k) {
  const std::uint32_t begin = begin_[k];
  const std::uint32_t end = begin_[k + 1];
  eliminated_.resize(std::max<std::size_t>(eliminated_.size(), end - begin));
  for (std::uint32_t i = begin; i < end; ++i)
    eliminated_[i - begin].noalias() = inverse_[k] * off_diagonal_[i];
  for (std::uint32_t j = begin; j < end; ++j) {
    const Eigen::Matrix3d own = off_diagonal_[j].transpose();
    const std::uint32_t column = rows_[j];
    diagonal_[column].noalias() -= own * eliminated_[j - begin];
    std::uint32_t at = begin_[column];
    for (std::uint32_t i = j + 1; i < end; ++i, ++at) {
      while (rows_[at] != rows_[i]) ++at;
      off_diagonal_[at].noalias() -= own * eliminated_[i - begin];
    }
  }
  for (std::uint32_t i = begin; i < end; ++i) off_diagonal_[i] = eliminated_[i - begin];
}

void TiedLandmarks::solve(std::span<Quad> by_landmark) const {
  const auto nodes = static_cast<std::uint32_t>(diagonal_.size());
  for (std::uint32_t k = 0; k < nodes; ++k) {
    const Eigen::Vector3d v = vector(by_landmark[untied_ + k]);
    for (std::uint32_t i = begin_[k]; i < begin_[k + 1]; ++i)
      add(by_landmark[untied_ + rows_[i]], -(off_diagonal_[i].transpose() * v));
  }
  for (std::uint32_t k = nodes; k-- > 0;) {
    Eigen::Vector3d y = inverse_[k] * vector(by_landmark[untied_ + k]);
    for (std::uint32_t i = begin_[k]; i < begin_[k + 1]; ++i)
      y -= off_diagonal_[i] * vector(by_landmark[untied_ + rows_[i]]);
    by_landmark[untied_ + k] = Quad{y[0], y[1], y[2], 0};
  }
}

void TiedLandmarks::write_switches(WindowGraph& graph) const {
  for (std::size_t a = 0; a < active_.size(); ++a) graph.set_switch(active_[a].tie, switch_values_[a]);
}

}  // namespace lanefuse
