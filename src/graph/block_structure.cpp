// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/block_structure.hpp"

#include <algorithm>
#include <cassert>

namespace lanefuse {

void BlockStructure::compute(const PoseGraph& graph, const EliminationOrder& order, const WeakTerms& weak) {
  landmarks_ = order.landmarks();
  columns_.assign(order.blocks(), {});
  rows_.clear();
  value_count_ = 0;
  add_landmark_columns(order);
  pose_values_ = value_count_;
  if (poses_are_dense()) {
    add_dense_pose_columns();
  } else {
    add_sparse_pose_columns(graph, order, weak);
  }
  updates_.clear();
  runs_.clear();
  for (std::uint32_t landmark = 0; landmark < landmarks_; ++landmark) add_updates(landmark);
  updates_.push_back({0, 0, runs_.size()});
}

void BlockStructure::add_landmark_columns(const EliminationOrder& order) {
  for (std::uint32_t landmark = 0; landmark < landmarks_; ++landmark) {
    const auto neighbours = order.neighbours(landmark);
    const auto count = static_cast<std::uint32_t>(neighbours.size() + 1);
    columns_[landmark] = {value_count_, 3 * std::size_t{count}, rows_.size(), count, 0};
    rows_.push_back(landmark);
    rows_.insert(rows_.end(), neighbours.begin(), neighbours.end());
    value_count_ += 9 * std::size_t{count};
  }
}

void BlockStructure::add_dense_pose_columns() {
  const std::uint32_t side = 3 * poses();
  // Column j lists the tail of one common list, and its values begin on the diagonal.
  const std::size_t first_row = rows_.size();
  for (std::uint32_t block = landmarks_; block < blocks(); ++block) rows_.push_back(block);
  for (std::uint32_t j = 0; j < poses(); ++j) {
    columns_[landmarks_ + j] = {pose_values_ + 3 * std::size_t{j} * (side + 1), side, first_row + j,
                                poses() - j, 0};
  }
  value_count_ = pose_values_ + std::size_t{side} * side;
}

void BlockStructure::add_sparse_pose_columns(const PoseGraph& graph, const EliminationOrder& order,
                                             const WeakTerms& weak) {
  pose_rows_.resize(poses());
  for (std::uint32_t j = 0; j < poses(); ++j) pose_rows_[j].assign(1, landmarks_ + j);
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (weak.joins_nothing(i)) continue;
    const Edge& edge = graph.edges[i];
    const auto [a, b] = std::minmax({order.block(edge.from), order.block(edge.to)});
    if (a >= landmarks_ && b != kHeld) pose_rows_[a - landmarks_].push_back(b);
  }
  for (std::uint32_t landmark = 0; landmark < landmarks_; ++landmark) {
    const auto all = order.neighbours(landmark);
    auto pose = std::lower_bound(all.begin(), all.end(), landmarks_);
    for (; pose != all.end(); ++pose) {
      auto& rows = pose_rows_[*pose - landmarks_];
      rows.insert(rows.end(), pose + 1, all.end());
    }
  }
  for (std::uint32_t j = 0; j < poses(); ++j) {
    auto& rows = pose_rows_[j];
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    const auto count = static_cast<std::uint32_t>(rows.size());
    columns_[landmarks_ + j] = {value_count_, 3 * std::size_t{count}, rows_.size(), count, 0};
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    value_count_ += 9 * std::size_t{count};
  }
}

void BlockStructure::add_updates(std::uint32_t landmark) {
  columns_[landmark].updates = updates_.size();
  const auto sources = rows(landmark);
  for (std::uint32_t i = 1; i < sources.size(); ++i) {
    updates_.push_back({sources[i], 3 * i, runs_.size()});
    add_runs(sources, i, rows(sources[i]));
  }
}

void BlockStructure::add_runs(std::span<const std::uint32_t> sources, std::uint32_t first,
                              std::span<const std::uint32_t> targets) {
  std::uint32_t target = 0;
  Run run{3 * first, 0, 0};
  for (std::uint32_t i = first; i < sources.size(); ++i, ++target) {
    if (targets[target] != sources[i]) {
      if (run.length > 0) runs_.push_back(run);
      target = static_cast<std::uint32_t>(
          std::lower_bound(targets.begin() + target, targets.end(), sources[i]) - targets.begin());
      assert(target < targets.size() && targets[target] == sources[i]);
      run = {3 * i, 3 * target, 0};
    }
    run.length += 3;
  }
  if (run.length > 0) runs_.push_back(run);
}

std::size_t BlockStructure::locate(std::uint32_t a, std::uint32_t b) const {
  const auto all = rows(a);
  const auto place = std::lower_bound(all.begin(), all.end(), b) - all.begin();
  assert(place < static_cast<std::ptrdiff_t>(all.size()) && all[static_cast<std::size_t>(place)] == b);
  return columns_[a].values + 3 * static_cast<std::size_t>(place);
}

}  // namespace lanefuse
