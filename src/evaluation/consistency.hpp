// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// Gathers (deviation / sigma)^2 by distance, and how often it lies inside the intervals of a normal error.
class ConsistencyByDistance {
 public:
  /// A sigma of zero claims nothing that could be judged, and is passed over.
  void add(std::size_t distance_index, double deviation, double sigma);
  void merge(const ConsistencyByDistance& other);
  [[nodiscard]] std::vector<ConsistencyStatistics> statistics() const;

 private:
  struct Sum {
    double squares = 0;
    std::uint64_t count = 0;
    std::array<std::uint64_t, 3> within{};  // the intervals of 68, 95 and 99 %
  };
  std::array<Sum, kDistanceCount> at_{};
};

}  // namespace lanefuse
