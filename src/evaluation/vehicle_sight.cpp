// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/vehicle_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lanefuse {
namespace {

/// What a vehicle covers of the view from the origin.
struct Silhouette {
  double bearing = 0;  ///< [rad] of its middle
  double right = 0;    ///< [rad] of its edges, relative to the middle
  double left = 0;
  double range = std::numeric_limits<double>::infinity();  ///< [m] of its nearest corner
};

Silhouette silhouette_of(const TrueObject& object, const Pose2& vehicle_from_world) {
  const Pose2 vehicle_from_object = vehicle_from_world * object.world_from_object;
  const Eigen::Vector2d middle = vehicle_from_object * Eigen::Vector2d(object.length / 2, 0);
  Silhouette silhouette{.bearing = std::atan2(middle.y(), middle.x())};
  for (const double x : {0.0, object.length}) {
    for (const double y : {-object.width / 2, object.width / 2}) {
      const Eigen::Vector2d corner = vehicle_from_object * Eigen::Vector2d(x, y);
      const double turn = wrap_angle(std::atan2(corner.y(), corner.x()) - silhouette.bearing);
      silhouette.right = std::min(silhouette.right, turn);
      silhouette.left = std::max(silhouette.left, turn);
      silhouette.range = std::min(silhouette.range, corner.norm());
    }
  }
  return silhouette;
}

struct Interval {
  double from = 0;
  double to = 0;
};

/// How much of [from, to] the intervals, in any order, leave free.
double free_length(const Interval& whole, std::vector<Interval>& covers) {
  std::sort(covers.begin(), covers.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  double free = 0;
  double end = whole.from;
  for (const Interval& cover : covers) {
    free += std::max(0.0, std::min(cover.from, whole.to) - end);
    end = std::clamp(cover.to, end, whole.to);
  }
  return free + whole.to - end;
}

}  // namespace

std::vector<double> shares_in_sight(const TrueFrame& frame) {
  const Pose2 vehicle_from_world = frame.world_from_vehicle.inverse();
  std::vector<Silhouette> silhouettes;
  for (const TrueObject& object : frame.objects)
    silhouettes.push_back(silhouette_of(object, vehicle_from_world));
  std::vector<double> shares;
  std::vector<Interval> covers;
  for (const Silhouette& one : silhouettes) {
    covers.clear();
    for (const Silhouette& other : silhouettes) {
      if (!(other.range < one.range)) continue;
      const double turn = wrap_angle(other.bearing - one.bearing);
      covers.push_back({turn + other.right, turn + other.left});
    }
    const double width = one.left - one.right;
    shares.push_back(width > 0 ? free_length({one.right, one.left}, covers) / width : 1);
  }
  return shares;
}

}  // namespace lanefuse
