// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "evaluation/lane_roles.hpp"
#include "evaluation/role_comparison.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// The true traffic that can help or hide: vehicles whose rear is within kAheadReach ahead of the car's
/// origin, by the lane that the middle of their rear is in.
inline constexpr double kAheadReach = 150;  ///< [m]
struct TrafficAhead {
  int vehicles = 0;           ///< on the ego lane and its neighbours
  std::optional<double> gap;  ///< [m] along x to the next one on the ego lane
};

TrafficAhead traffic_ahead(const TrueFrame& frame, const TrueRoles& truth);

/// Deviations gathered apart for each range of a condition.
class ConditionedDeviations {
 public:
  /// Ranges [limits[i], limits[i + 1]), the last one without end; `limits` in order.
  explicit ConditionedDeviations(std::span<const double> limits);

  /// One cycle in which the condition had that value, at least limits[0].
  void add(double value, const std::vector<RoleDeviation>& deviations);
  [[nodiscard]] std::vector<ConditionStatistics> statistics() const;

 private:
  struct Bin {
    double from = 0;
    std::uint64_t cycles = 0;
    RoleDeviations deviations;
  };
  std::vector<Bin> bins_;
};

}  // namespace lanefuse
