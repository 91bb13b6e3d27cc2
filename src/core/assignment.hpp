// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace lanefuse {

/// Who belongs to whom at the least total cost: the optimal one-to-one assignment of rows to columns of a
/// dense matrix, where any row may also stay alone. By shortest augmenting paths [Jonker and Volgenant, "A
/// shortest augmenting path algorithm for dense and sparse linear assignment problems", Computing 38, 1987],
/// in O(rows^2 columns). It keeps its workspace: once it has seen its largest problem, it allocates no more.
class Assignment {
 public:
  static constexpr double kForbidden =
      std::numeric_limits<double>::infinity();  ///< cost of an impossible pair
  static constexpr int kAlone = -1;

  /// For each row its column, or kAlone. `costs` is row-major, each finite (of any sign) or kForbidden;
  /// `skip` is the finite cost of leaving a row alone. Where several are optimal, the same one comes out each
  /// time. The answer is valid until the next call.
  std::span<const int> solve(int rows, int columns, std::span<const double> costs, double skip);

  /// The same with cost(row, column) asked once for each pair.
  template <typename Cost>
  requires requires(const Cost& cost, int index) { static_cast<double>(cost(index, index)); }
  std::span<const int> solve(int rows, int columns, const Cost& cost, double skip) {
    costs_.clear();
    costs_.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) costs_.push_back(cost(row, column));
    return solve(rows, columns, std::span<const double>(costs_), skip);
  }

 private:
  /// Where a path of least reduced cost ends: at a free column, or at a row that had best stay alone.
  struct PathEnd {
    double length = 0;
    int column = kAlone;
    int row = kAlone;  ///< the row before it
  };

  void augment(int start, std::span<const double> costs, double skip);
  [[nodiscard]] PathEnd shortest_path(int start, std::span<const double> costs, double skip);
  void scan_row(int row, double length, std::span<const double> costs);
  [[nodiscard]] int nearest_open_column() const;
  void raise_prices(int start, double length);

  std::vector<double> costs_;      ///< what a cost function said
  std::vector<int> column_of_;     ///< [row]
  std::vector<int> row_of_;        ///< [column]
  std::vector<double> row_price_;  ///< dual variables
  std::vector<double> column_price_;
  std::vector<double> distance_;   ///< [column] along the shortest path known
  std::vector<int> previous_row_;  ///< [column] on that path
  std::vector<char> closed_;       ///< [column] whose shortest path is final
};

}  // namespace lanefuse
