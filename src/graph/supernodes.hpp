// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lanefuse {

/// The shape that the Cholesky factor of a symmetric block matrix will have: an order of little fill
/// (approximate minimum degree), and its columns taken together in panels of like shape (supernodes), so that
/// the factorisation is work on dense pieces. A few zeros are let in where that makes panels wider.
class Supernodes {
 public:
  struct Panel {
    std::uint32_t first = 0;    ///< its first column, counted in turns
    std::uint32_t columns = 0;  ///< how many
    std::uint32_t count = 0;  ///< how many row blocks: its own columns first, then the later ones, ascending
    std::size_t rows = 0;     ///< where they are listed
    std::size_t values = 0;   ///< where its numbers begin: lines of 3 count, one a scalar column
    [[nodiscard]] std::size_t height() const { return 3 * std::size_t{count}; }
    [[nodiscard]] std::size_t width() const { return 3 * std::size_t{columns}; }
  };

  /// `neighbours[i]`: the blocks that share a nonzero block with block i, in any order; i itself may be
  /// there.
  void analyse(const std::vector<std::vector<std::uint32_t>>& neighbours);

  [[nodiscard]] const std::vector<std::uint32_t>& turns() const { return turn_of_block_; }
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  [[nodiscard]] std::span<const std::uint32_t> rows(const Panel& panel) const {
    return {rows_.data() + panel.rows, panel.count};
  }
  [[nodiscard]] std::uint32_t panel_of(std::uint32_t turn) const { return panel_of_turn_[turn]; }
  [[nodiscard]] std::size_t value_count() const { return value_count_; }
  /// Where the block of this row and column (turns, row >= column) begins; it must be in the shape.
  [[nodiscard]] std::size_t locate(std::uint32_t row, std::uint32_t column) const;

 private:
  void order(const std::vector<std::vector<std::uint32_t>>& neighbours);
  void find_columns(const std::vector<std::vector<std::uint32_t>>& neighbours);
  void join_columns();
  void lay_out();

  std::vector<std::uint32_t> turn_of_block_;
  std::vector<std::uint32_t> block_of_turn_;
  std::vector<std::vector<std::uint32_t>> below_;  ///< of a column: its later row blocks, ascending
  std::vector<Panel> panels_;
  std::vector<std::uint32_t> panel_of_turn_;
  std::vector<std::uint32_t> rows_;
  std::size_t value_count_ = 0;
};

}  // namespace lanefuse
