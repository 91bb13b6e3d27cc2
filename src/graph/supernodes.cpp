// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/supernodes.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace lanefuse {

namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Who is eliminated onto whom first: of each turn the next one that its column reaches, or kNone.
std::vector<std::uint32_t> elimination_tree(const std::vector<std::vector<std::uint32_t>>& neighbours,
                                            const std::vector<std::uint32_t>& turn_of_block,
                                            const std::vector<std::uint32_t>& block_of_turn) {
  std::vector<std::uint32_t> parent(block_of_turn.size(), kNone), shortcut(parent);
  for (std::uint32_t turn = 0; turn < parent.size(); ++turn) {
    for (const std::uint32_t block : neighbours[block_of_turn[turn]]) {
      for (std::uint32_t at = turn_of_block[block]; at < turn;) {
        const std::uint32_t next = shortcut[at];
        shortcut[at] = turn;
        if (next == kNone) parent[at] = turn;
        at = std::min(next, turn);
      }
    }
  }
  return parent;
}

/// The turns so numbered that whatever is eliminated onto a column comes right before it.
std::vector<std::uint32_t> postorder(const std::vector<std::uint32_t>& parent) {
  std::vector<std::vector<std::uint32_t>> children(parent.size());
  std::vector<std::uint32_t> stack, order;
  for (auto turn = static_cast<std::uint32_t>(parent.size()); turn-- > 0;) {
    (parent[turn] == kNone ? stack : children[parent[turn]]).push_back(turn);
  }
  while (!stack.empty()) {
    const std::uint32_t turn = stack.back();
    if (children[turn].empty()) {
      order.push_back(turn);
      stack.pop_back();
    } else {
      stack.push_back(children[turn].back());
      children[turn].pop_back();
    }
  }
  return order;
}

}  // namespace

void Supernodes::analyse(const std::vector<std::vector<std::uint32_t>>& neighbours) {
  order(neighbours);
  find_columns(neighbours);
  join_columns();
  lay_out();
}

void Supernodes::order(const std::vector<std::vector<std::uint32_t>>& neighbours) {
  const auto blocks = static_cast<int>(neighbours.size());
  Eigen::SparseMatrix<double> pattern(blocks, blocks);
  std::vector<Eigen::Triplet<double>> ties;
  for (int block = 0; block < blocks; ++block) {
    ties.emplace_back(block, block, 1.0);
    for (const std::uint32_t other : neighbours[static_cast<std::size_t>(block)]) {
      ties.emplace_back(static_cast<int>(other), block, 1.0);
    }
  }
  pattern.setFromTriplets(ties.begin(), ties.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), permutation);
  const auto& block_at = permutation.indices();
  turn_of_block_.resize(neighbours.size());
  block_of_turn_.assign(block_at.data(), block_at.data() + blocks);
  const auto number = [&] {
    for (std::uint32_t turn = 0; turn < neighbours.size(); ++turn)
      turn_of_block_[block_of_turn_[turn]] = turn;
  };
  number();
  auto by_tree = postorder(elimination_tree(neighbours, turn_of_block_, block_of_turn_));
  for (std::uint32_t& turn : by_tree) turn = block_of_turn_[turn];
  block_of_turn_ = std::move(by_tree);
  number();
}

void Supernodes::find_columns(const std::vector<std::vector<std::uint32_t>>& neighbours) {
  const std::size_t columns = neighbours.size();
  below_.assign(columns, {});
  std::vector<std::vector<std::uint32_t>> children(columns);
  std::vector<std::uint32_t> seen_by(columns, kNone);
  for (std::uint32_t column = 0; column < columns; ++column) {
    auto& below = below_[column];
    const auto add = [&](std::uint32_t row) {
      if (row <= column || seen_by[row] == column) return;
      seen_by[row] = column;
      below.push_back(row);
    };
    for (const std::uint32_t block : neighbours[block_of_turn_[column]]) add(turn_of_block_[block]);
    for (const std::uint32_t child : children[column]) {
      for (const std::uint32_t row : below_[child]) add(row);
    }
    std::sort(below.begin(), below.end());
    if (!below.empty()) children[below.front()].push_back(column);
  }
}

void Supernodes::join_columns() {
  // From the last column back: a column joins the panel behind it if it is eliminated onto that panel's first
  // column and its own shape differs little.
  constexpr std::size_t kAlwaysJoined = 4;  // columns
  constexpr double kZerosOfFew = 0.5, kZerosOfSome = 0.12, kZerosOfMany = 0.05;
  panels_.clear();
  std::size_t zeros = 0;  // blocks of the panel that the factor does not have
  for (auto column = static_cast<std::uint32_t>(below_.size()); column-- > 0;) {
    const std::size_t own = below_[column].size() + 1;
    const bool reaches = !panels_.empty() && own > 1 && below_[column].front() == panels_.back().first;
    if (reaches) {
      Panel& panel = panels_.back();
      const std::size_t columns = panel.columns + std::size_t{1}, count = panel.count + std::size_t{1};
      const std::size_t joined_zeros = zeros + count - own;
      const std::size_t blocks = columns * count - columns * (columns - 1) / 2;
      const double share = static_cast<double>(joined_zeros) / static_cast<double>(blocks);
      const double most = columns <= 8 ? kZerosOfFew : columns <= 24 ? kZerosOfSome : kZerosOfMany;
      if (count == own || (columns <= kAlwaysJoined && count <= 12) || share <= most) {
        panel = {column, panel.columns + 1, panel.count + 1, 0, 0};
        zeros = joined_zeros;
        continue;
      }
    }
    panels_.push_back({column, 1, static_cast<std::uint32_t>(own), 0, 0});
    zeros = 0;
  }
  std::reverse(panels_.begin(), panels_.end());
}

void Supernodes::lay_out() {
  rows_.clear();
  value_count_ = 0;
  panel_of_turn_.resize(below_.size());
  for (std::uint32_t p = 0; p < panels_.size(); ++p) {
    Panel& panel = panels_[p];
    panel.rows = rows_.size();
    panel.values = value_count_;
    for (std::uint32_t k = 0; k < panel.columns; ++k) {
      rows_.push_back(panel.first + k);
      panel_of_turn_[panel.first + k] = p;
    }
    const auto& last = below_[panel.first + panel.columns - 1];
    rows_.insert(rows_.end(), last.begin(), last.end());
    value_count_ += panel.height() * panel.width();
  }
}

std::size_t Supernodes::locate(std::uint32_t row, std::uint32_t column) const {
  const Panel& panel = panels_[panel_of_turn_[column]];
  const auto all = rows(panel);
  const auto place = std::lower_bound(all.begin(), all.end(), row) - all.begin();
  assert(place < static_cast<std::ptrdiff_t>(all.size()) && all[static_cast<std::size_t>(place)] == row);
  return panel.values + 3 * (column - panel.first) * panel.height() + 3 * static_cast<std::size_t>(place);
}

}  // namespace lanefuse
