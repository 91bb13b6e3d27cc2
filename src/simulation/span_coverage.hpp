// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace lanefuse {

/// How much of each pixel of a row something covers, in [0, 1], summed up from spans with exact ends.
class SpanCoverage {
 public:
  explicit SpanCoverage(int width) : width_(width), share_(static_cast<std::size_t>(width)) {}

  /// Covers `share` of the row's height between the columns `left` and `right` [px]; pixel u reaches from
  /// u - 1/2 to u + 1/2.
  void add(double left, double right, float share) {
    left = std::max(left + 0.5, 0.0);
    right = std::min(right + 0.5, static_cast<double>(width_));
    if (!(left < right)) return;
    const int first = static_cast<int>(left);
    const int last = std::min(static_cast<int>(right), width_ - 1);
    begin_ = std::min(begin_, first);
    end_ = std::max(end_, last + 1);
    if (first == last) {
      share_[static_cast<std::size_t>(first)] += share * static_cast<float>(right - left);
      return;
    }
    share_[static_cast<std::size_t>(first)] += share * static_cast<float>(first + 1 - left);
    for (int u = first + 1; u < last; ++u) share_[static_cast<std::size_t>(u)] += share;
    share_[static_cast<std::size_t>(last)] += share * static_cast<float>(right - last);
  }

  [[nodiscard]] int begin() const { return begin_; }  ///< [px] the first column that is covered
  [[nodiscard]] int end() const { return end_; }      ///< [px] one beyond the last
  [[nodiscard]] float at(int u) const { return std::min(share_[static_cast<std::size_t>(u)], 1.0F); }

  void clear() {
    if (begin_ < end_) std::fill(share_.begin() + begin_, share_.begin() + end_, 0.0F);
    begin_ = width_;
    end_ = 0;
  }

 private:
  int width_;
  int begin_ = width_;
  int end_ = 0;
  std::vector<float> share_;
};

}  // namespace lanefuse
