// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/traffic_ahead.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace lanefuse {
namespace {

/// Between two roles' lines, where both are.
bool is_between(const Eigen::Vector2d& place, const RoleLine& left, const RoleLine& right) {
  const std::optional<double> left_y = left.y(place.x());
  const std::optional<double> right_y = right.y(place.x());
  return left_y && right_y && *right_y <= place.y() && place.y() < *left_y;
}

}  // namespace

TrafficAhead traffic_ahead(const TrueFrame& frame, const TrueRoles& truth) {
  const Pose2 vehicle_from_world = frame.world_from_vehicle.inverse();
  TrafficAhead ahead;
  for (const TrueObject& object : frame.objects) {
    const Eigen::Vector2d rear = vehicle_from_world * object.world_from_object.position();
    if (rear.x() <= 0 || rear.x() > kAheadReach) continue;
    const bool on_ego_lane = is_between(rear, truth[kEgoLeft], truth[kEgoRight]);
    if (on_ego_lane) ahead.gap = std::min(ahead.gap.value_or(rear.x()), rear.x());
    if (on_ego_lane || is_between(rear, truth[kAdjacentLeft], truth[kEgoLeft]) ||
        is_between(rear, truth[kEgoRight], truth[kAdjacentRight])) {
      ++ahead.vehicles;
    }
  }
  return ahead;
}

ConditionedDeviations::ConditionedDeviations(std::span<const double> limits) {
  for (const double limit : limits) bins_.push_back({limit, 0, {}});
}

void ConditionedDeviations::add(double value, const std::vector<RoleDeviation>& deviations) {
  const auto after = std::upper_bound(bins_.begin(), bins_.end(), value,
                                      [](double v, const Bin& bin) { return v < bin.from; });
  assert(after != bins_.begin());
  Bin& bin = *(after - 1);
  ++bin.cycles;
  for (const RoleDeviation& one : deviations) bin.deviations.add(one);
}

std::vector<ConditionStatistics> ConditionedDeviations::statistics() const {
  std::vector<ConditionStatistics> result;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    const double to = i + 1 < bins_.size() ? bins_[i + 1].from : std::numeric_limits<double>::infinity();
    result.push_back({bins_[i].from, to, bins_[i].cycles, bins_[i].deviations.statistics()});
  }
  return result;
}

}  // namespace lanefuse
