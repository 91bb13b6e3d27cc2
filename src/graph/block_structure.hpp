// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/elimination_order.hpp"
#include "graph/weak_terms.hpp"

namespace lanefuse {

/// Where the 3x3 blocks of the normal equations live in one array of numbers, worked out once a solve.
///
/// Of the symmetric matrix the lower triangle is kept, by block columns. Block column a holds the rows of
/// blocks `rows(a)` (itself first, then later ones, ascending) as three lines of numbers, one a scalar
/// column: the number of scalar column c and scalar row r of the i-th row block stands at values(a) + c *
/// stride(a) + 3 i + r. Landmarks have the columns that their elimination fills. Poses are one dense square
/// when they are few (then a line also spans the unused upper triangle), else compressed sparse columns: both
/// as Eigen reads them in place.
class BlockStructure {
 public:
  struct Column {
    std::size_t values = 0;   ///< where the column's first line begins
    std::size_t stride = 0;   ///< from one line to the next
    std::size_t rows = 0;     ///< where its row blocks are listed
    std::uint32_t count = 0;  ///< how many row blocks
    std::size_t updates = 0;  ///< landmarks: where its updates begin
  };
  /// Numbers next to each other both in an eliminated landmark's lines and in the column they are subtracted
  /// from.
  struct Run {
    std::uint32_t source = 0;  ///< place in the landmark's line
    std::uint32_t target = 0;  ///< place in the updated column's line
    std::uint32_t length = 0;
  };
  /// What the elimination of a landmark subtracts from one later column.
  struct Update {
    std::uint32_t column = 0;
    std::uint32_t source = 0;  ///< place of that column's own block in the landmark's line
    std::size_t runs = 0;      ///< its first run; the next update's is past its last
  };

  /// Where there are many poses, those that only `weak` terms join share no block.
  void compute(const PoseGraph& graph, const EliminationOrder& order, const WeakTerms& weak = {});

  [[nodiscard]] std::uint32_t landmarks() const { return landmarks_; }
  [[nodiscard]] std::uint32_t blocks() const { return static_cast<std::uint32_t>(columns_.size()); }
  [[nodiscard]] std::uint32_t poses() const { return blocks() - landmarks_; }
  [[nodiscard]] bool poses_are_dense() const { return is_dense(poses()); }
  /// Whether so many poses are laid out as one dense square.
  [[nodiscard]] static bool is_dense(std::uint32_t poses) { return poses <= kMostDensePoses; }
  [[nodiscard]] std::size_t value_count() const { return value_count_; }
  [[nodiscard]] std::size_t pose_values() const { return pose_values_; }  ///< where the poses' part begins

  [[nodiscard]] const Column& column(std::uint32_t block) const { return columns_[block]; }
  [[nodiscard]] std::span<const std::uint32_t> rows(std::uint32_t block) const {
    return {rows_.data() + columns_[block].rows, columns_[block].count};
  }
  /// A landmark's updates, one a later block it is tied to, in the order of its rows.
  [[nodiscard]] std::span<const Update> updates(std::uint32_t landmark) const {
    return {updates_.data() + columns_[landmark].updates, columns_[landmark].count - 1};
  }
  [[nodiscard]] std::span<const Run> runs(const Update& update) const {
    return {runs_.data() + update.runs, runs_.data() + (&update + 1)->runs};
  }
  /// Where the block of column `a` and row `b` > a begins; it must exist.
  [[nodiscard]] std::size_t locate(std::uint32_t a, std::uint32_t b) const;

 private:
  static constexpr std::uint32_t kMostDensePoses = 200;

  void add_landmark_columns(const EliminationOrder& order);
  void add_dense_pose_columns();
  void add_sparse_pose_columns(const PoseGraph& graph, const EliminationOrder& order, const WeakTerms& weak);
  void add_updates(std::uint32_t landmark);
  void add_runs(std::span<const std::uint32_t> sources, std::uint32_t first,
                std::span<const std::uint32_t> targets);

  std::uint32_t landmarks_ = 0;
  std::size_t value_count_ = 0;
  std::size_t pose_values_ = 0;
  std::vector<Column> columns_;
  std::vector<std::uint32_t> rows_;
  std::vector<Update> updates_;  ///< with one more at the end, to close the last one's runs
  std::vector<Run> runs_;
  std::vector<std::vector<std::uint32_t>> pose_rows_;
};

}  // namespace lanefuse
