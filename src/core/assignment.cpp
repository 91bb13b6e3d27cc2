// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/assignment.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace lanefuse {

std::span<const int> Assignment::solve(int rows, int columns, std::span<const double> costs, double skip) {
  assert(rows >= 0 && columns >= 0 && std::isfinite(skip));
  assert(costs.size() == static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  const auto row_count = static_cast<std::size_t>(rows);
  const auto column_count = static_cast<std::size_t>(columns);
  column_of_.assign(row_count, kAlone);
  row_price_.assign(row_count, 0);
  row_of_.assign(column_count, kAlone);
  column_price_.assign(column_count, 0);
  previous_row_.assign(column_count, kAlone);
  for (int row = 0; row < rows; ++row) augment(row, costs, skip);
  return column_of_;
}

void Assignment::augment(int start, std::span<const double> costs, double skip) {
  const PathEnd end = shortest_path(start, costs, skip);
  raise_prices(start, end.length);
  // Walk the path back: each row hands its column on to the row before it.
  int row = end.row;
  int column = end.column;
  while (true) {
    const int handed_on = std::exchange(column_of_[static_cast<std::size_t>(row)], column);
    if (column != kAlone) row_of_[static_cast<std::size_t>(column)] = row;
    if (row == start) return;
    column = handed_on;
    row = previous_row_[static_cast<std::size_t>(column)];
  }
}

/// Dijkstra's search over reduced costs. A row that stays alone would do so on a column of its own that
/// nobody else may take; such a column only ever ends a path, so that it needs no place in the matrix.
Assignment::PathEnd Assignment::shortest_path(int start, std::span<const double> costs, double skip) {
  distance_.assign(row_of_.size(), kForbidden);
  closed_.assign(row_of_.size(), 0);
  PathEnd alone{.length = kForbidden};
  int row = start;
  double length = 0;
  while (true) {
    const double staying = length + skip - row_price_[static_cast<std::size_t>(row)];
    if (staying < alone.length) alone = {.length = staying, .row = row};
    scan_row(row, length, costs);
    const int nearest = nearest_open_column();
    if (nearest == kAlone) return alone;
    const auto column = static_cast<std::size_t>(nearest);
    if (alone.length < distance_[column]) return alone;
    length = distance_[column];
    if (row_of_[column] == kAlone) return {.length = length, .column = nearest, .row = previous_row_[column]};
    closed_[column] = 1;
    row = row_of_[column];
  }
}

void Assignment::scan_row(int row, double length, std::span<const double> costs) {
  const std::size_t columns = row_of_.size();
  const auto row_costs = costs.subspan(static_cast<std::size_t>(row) * columns, columns);
  const double base = length - row_price_[static_cast<std::size_t>(row)];
  for (std::size_t column = 0; column < columns; ++column) {
    const double distance = base + row_costs[column] - column_price_[column];
    if (closed_[column] == 0 && distance < distance_[column]) {
      distance_[column] = distance;
      previous_row_[column] = row;
    }
  }
}

int Assignment::nearest_open_column() const {
  int nearest = kAlone;
  double least = kForbidden;
  for (std::size_t column = 0; column < distance_.size(); ++column)
    if (closed_[column] == 0 && distance_[column] < least) {
      least = distance_[column];
      nearest = static_cast<int>(column);
    }
  return nearest;
}

/// Keeps every reduced cost at or above zero and those of the assigned pairs at zero, once the path is taken.
void Assignment::raise_prices(int start, double length) {
  row_price_[static_cast<std::size_t>(start)] += length;
  for (std::size_t column = 0; column < closed_.size(); ++column) {
    if (closed_[column] == 0) continue;
    const double slack = length - distance_[column];
    row_price_[static_cast<std::size_t>(row_of_[column])] += slack;
    column_price_[column] -= slack;
  }
}

}  // namespace lanefuse
