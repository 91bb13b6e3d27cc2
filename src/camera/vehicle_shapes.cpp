// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/vehicle_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "camera/ground_projection.hpp"

namespace lanefuse {
namespace {

constexpr double kLength = 4.6;       ///< [m] of a car
constexpr double kHeight = 1.45;      ///< [m]
constexpr double kLeastVisible = 7;   ///< [px] of the reduced image
constexpr double kLeastAspect = 0.3;  ///< of what is left of a cut box: width over height
constexpr double kLongStep = 1.045;   ///< from one distance to the next
constexpr double kCar = 0.33;         ///< of the way from the narrowest vehicle to the widest
constexpr double kLateralStep = 0.3;  ///< [m]

/// Grows a box by the pixels of points over one place of the road.
class Outline {
 public:
  Outline(const GroundProjection& projection, const Reduction& reduction)
      : projection_(projection), reduction_(reduction) {}

  /// The column of the place, or nothing where the camera cannot see it.
  std::optional<double> add(double x, double y) {
    const auto base = projection_.pixel({x, y});
    const auto roof = projection_.pixel({x, y}, kHeight);
    if (!base || !roof) return {};
    const double column = reduction_.column(base->x());
    box_.left = std::min(box_.left, column);
    box_.right = std::max(box_.right, column);
    // What lies beside the image says nothing of the rows that are seen.
    if (column < 0 || column > reduction_.width) return column;
    box_.top = std::min(box_.top, reduction_.row(roof->y()));
    box_.bottom = std::max(box_.bottom, reduction_.row(base->y()));
    return column;
  }
  [[nodiscard]] const PixelBox& box() const { return box_; }

 private:
  const GroundProjection& projection_;
  const Reduction& reduction_;
  static constexpr double kFar = 1e9;
  PixelBox box_{kFar, kFar, -kFar, -kFar};
};

std::optional<VehicleShape> shape_at(const GroundProjection& projection, const Reduction& reduction,
                                     VehicleShape shape) {
  Outline outline(projection, reduction);
  const double x = shape.distance;
  const auto left = outline.add(x, shape.lateral + shape.width / 2);
  const auto right = outline.add(x, shape.lateral - shape.width / 2);
  if (!left || !right) return {};
  // The side that is turned to the camera, and the far end of the other one where the car is straight ahead.
  const double beside = shape.lateral - projection.pose().mounting.y;
  const double side = beside > 0 ? shape.lateral - shape.width / 2 : shape.lateral + shape.width / 2;
  constexpr int kSteps = 8;
  for (int i = 1; i <= kSteps && std::abs(beside) > shape.width / 2; ++i) {
    outline.add(x + kLength * i / kSteps, side);
  }
  shape.rear_left = *left;
  shape.rear_right = *right;
  shape.box = outline.box();
  shape.left_cut = shape.box.left < 0;
  shape.right_cut = shape.box.right > reduction.width;
  shape.box.left = std::max(shape.box.left, 0.0);
  shape.box.right = std::min(shape.box.right, static_cast<double>(reduction.width));
  shape.box.top = std::max(shape.box.top, 0.0);
  shape.box.bottom = std::min(shape.box.bottom, static_cast<double>(reduction.height));
  const bool sliver = shape.box.width() < kLeastAspect * shape.box.height();
  if (sliver || shape.box.width() < kLeastVisible || shape.box.height() < kLeastVisible) return {};
  return shape;
}

}  // namespace

double overlap(const PixelBox& a, const PixelBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  if (!(width > 0) || !(height > 0)) return 0;
  const double both = width * height;
  return both / (a.width() * a.height() + b.width() * b.height() - both);
}

std::vector<VehicleShape> vehicle_shapes(const CameraModel& camera, const CameraPose& pose,
                                         const Reduction& reduction, const VehicleDetectorConfig& config) {
  const GroundProjection projection(camera, pose);
  std::vector<VehicleShape> shapes;
  for (double x = config.nearest; x <= config.farthest; x *= kLongStep) {
    const auto sides = static_cast<int>(config.widest_view / kLateralStep);
    for (int i = -sides; i <= sides; ++i) {
      VehicleShape shape;
      shape.distance = pose.mounting.x + x;
      shape.lateral = i * kLateralStep;
      shape.width = config.narrowest + kCar * (config.widest - config.narrowest);
      if (const auto seen = shape_at(projection, reduction, shape)) shapes.push_back(*seen);
    }
  }
  return shapes;
}

}  // namespace lanefuse
