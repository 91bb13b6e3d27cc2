// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/vehicle_regions.hpp"

#include <algorithm>

namespace lanefuse {
namespace {

constexpr double kTruckLength = 7;    ///< [m] from which on a vehicle counts as high
constexpr double kTruckHeight = 3.8;  ///< [m]
constexpr double kCarHeight = 1.5;    ///< [m]
constexpr double kNearest = 3;        ///< [m] ahead

}  // namespace

std::optional<VehicleBox> vehicle_region(const TrackedObject& object, const GroundProjection& projection) {
  if (object.x < kNearest) return {};
  const double height = object.length >= kTruckLength ? kTruckHeight : kCarHeight;
  const auto lower_left = projection.pixel({object.x, object.y + object.width / 2});
  const auto lower_right = projection.pixel({object.x, object.y - object.width / 2});
  const auto top = projection.pixel({object.x, object.y}, height);
  if (!lower_left || !lower_right || !top) return {};
  // A vehicle that is not straight ahead shows its side as well, up to its front.
  double left = lower_left->x();
  double right = lower_right->x();
  for (const double side : {0.5, -0.5}) {
    const auto front = projection.pixel({object.x + object.length, object.y + side * object.width});
    if (!front) continue;
    left = std::min(left, front->x());
    right = std::max(right, front->x());
  }
  return VehicleBox{left,     top->y(), right,        std::max(lower_left->y(), lower_right->y()),
                    object.x, object.y, object.width, object.existence};
}

}  // namespace lanefuse
