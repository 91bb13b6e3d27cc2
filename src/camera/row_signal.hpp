// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "camera/image.hpp"
#include "camera/row_plan.hpp"

namespace lanefuse {

/// How bright, or how yellow, the pixels of a row are: paint of either colour stands out of it, on asphalt
/// and on concrete. Rows that are summed make one signal. Its unit is the grey level times the rows.
class RowSignal {
 public:
  explicit RowSignal(int width);

  /// Reads columns [row.begin, row.end) and nothing else.
  void read(const ImageView& image, const PlannedRow& row);

  [[nodiscard]] int begin() const { return begin_; }
  [[nodiscard]] int end() const { return end_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int level(int column) const { return levels_[static_cast<std::size_t>(column)]; }
  /// Of columns [from, to), which must lie within [begin, end).
  [[nodiscard]] int sum(int from, int to) const { return sums()[to] - sums()[from]; }
  /// sums()[u]: the sum of the columns before u, for u in [begin, end].
  [[nodiscard]] const std::int32_t* sums() const { return sums_.data(); }

 private:
  int begin_ = 0;
  int end_ = 0;
  int rows_ = 1;
  std::vector<std::uint8_t> planes_;
  std::vector<std::uint16_t> levels_;
  std::vector<std::int32_t> sums_;

  void add(const ImageView& image, int row);
};

}  // namespace lanefuse
