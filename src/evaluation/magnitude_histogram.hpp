// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace lanefuse {

/// Counts how large deviations are, in bins that grow by 1 % from 1 mm to 100 m: quantiles to half a percent
/// in memory that does not grow with the drive.
class MagnitudeHistogram {
 public:
  /// `magnitude` >= 0 [m].
  void add(double magnitude);
  void merge(const MagnitudeHistogram& other);

  /// The magnitude that `share` (in (0, 1]) of the values do not exceed, by nearest rank; NaN where there are
  /// none. Never outside the smallest and the largest value seen, so that equal values give their own value
  /// back.
  [[nodiscard]] double quantile(double share) const;

 private:
  std::vector<std::uint64_t> bins_;  // allocated with the first value
  std::uint64_t count_ = 0;
  double smallest_ = 0;
  double largest_ = 0;
};

}  // namespace lanefuse
