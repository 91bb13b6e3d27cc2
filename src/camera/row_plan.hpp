// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "camera/ground_projection.hpp"

namespace lanefuse {

/// An image row that tells something about the road which the row below did not.
struct PlannedRow {
  int row = 0;          ///< [px]
  int half_height = 0;  ///< [px] rows above and below that are summed with it
  int begin = 0;        ///< [px] first column of the road
  int end = 0;          ///< [px] behind its last column
  int core_begin = 0;   ///< [px] the same of the lanes around the car, where the row's noise is measured
  int core_end = 0;     ///< [px]
  double distance = 0;  ///< [m] to the road straight ahead
  double scale = 0;     ///< [px/m] across the road

  [[nodiscard]] int height() const { return 2 * half_height + 1; }
};

/// Which rows to look at.
struct RowPlanConfig {
  double range_min = 6;      ///< [m]
  double range_max = 130;    ///< [m]
  double lateral_max = 14;   ///< [m]
  double core_lateral = 6;   ///< [m]
  double radius_min = 400;   ///< [m] of bends that the columns must leave room for
  double row_spacing = 0.5;  ///< [m] on the road
};

/// Rows from near to far, at least `row_spacing` apart on the road; far away that is every row there is.
void plan_rows(const GroundProjection& projection, const CameraIntrinsics& camera,
               const RowPlanConfig& config, std::vector<PlannedRow>& rows);

}  // namespace lanefuse
