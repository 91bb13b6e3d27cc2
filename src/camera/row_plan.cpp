// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/row_plan.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr int kRowsBetweenSums = 6;  ///< [px] rows so far apart have neighbours that no other row uses

/// The column of a place on the road, kept inside of the image.
int column_of(const GroundProjection& projection, const CameraIntrinsics& camera,
              const Eigen::Vector2d& place) {
  const auto pixel = projection.pixel(place);
  const double column = pixel ? pixel->x() : place.y() > 0 ? 0 : camera.width;
  return static_cast<int>(std::clamp(column, 0.0, static_cast<double>(camera.width)));
}

PlannedRow planned(const GroundProjection& projection, const CameraIntrinsics& camera,
                   const RowPlanConfig& config, int row, double x) {
  const double reach = config.lateral_max + x * x / (2 * config.radius_min);
  PlannedRow plan;
  plan.row = row;
  plan.begin = column_of(projection, camera, {x, reach});
  plan.end = column_of(projection, camera, {x, -reach});
  plan.core_begin = column_of(projection, camera, {x, config.core_lateral});
  plan.core_end = column_of(projection, camera, {x, -config.core_lateral});
  plan.distance = x;
  const auto left = projection.pixel({x, 0.5});
  const auto right = projection.pixel({x, -0.5});
  plan.scale = left && right ? (*right - *left).norm() : 0;
  return plan;
}

}  // namespace

void plan_rows(const GroundProjection& projection, const CameraIntrinsics& camera,
               const RowPlanConfig& config, std::vector<PlannedRow>& rows) {
  rows.clear();
  const auto axis = projection.pixel({config.range_max / 2, 0});
  if (!axis) return;
  int last = camera.height;
  double x = config.range_min;
  while (x <= config.range_max) {
    const auto wanted = projection.pixel({x, 0});
    if (!wanted) break;
    const int row = std::min(last - 1, static_cast<int>(std::floor(wanted->y())));
    if (row < 0) break;
    const auto seen = projection.ground({axis->x(), static_cast<double>(row)});
    if (!seen || seen->x() > config.range_max) break;
    if (row < camera.height - 1) {
      PlannedRow plan = planned(projection, camera, config, row, seen->x());
      plan.half_height = last - row >= kRowsBetweenSums && last < camera.height && row > 0 ? 1 : 0;
      rows.push_back(plan);
      last = row;
    }
    x = std::max(x, seen->x()) + config.row_spacing;
  }
}

}  // namespace lanefuse
