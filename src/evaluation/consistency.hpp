// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// Gathers by distance (deviation / sigma)^2, how often it lies inside the intervals of a normal error, and
/// how often a deviation is beyond the protection level that came with it.
class ConsistencyByDistance {
 public:
  /// A sigma of zero claims nothing that could be judged, and is passed over.
  void add(std::size_t distance_index, double deviation, double sigma);
  /// A protection level of zero vouches for nothing, and is passed over.
  void add_protection(std::size_t distance_index, double deviation, double protection);
  void merge(const ConsistencyByDistance& other);
  [[nodiscard]] std::vector<ConsistencyStatistics> statistics() const;

 private:
  struct Sum {
    double squares = 0;
    double sigmas = 0;
    std::uint64_t count = 0;
    std::array<std::uint64_t, 3> within{};  // the intervals of 68, 95 and 99 %
    double protection = 0;
    std::uint64_t protected_count = 0;
    std::uint64_t misleading = 0;  // beyond their protection level
  };
  std::array<Sum, kDistanceCount> at_{};
};

}  // namespace lanefuse
