// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "camera/edge_search.hpp"
#include "camera/lane_filter.hpp"
#include "camera/paint_memory.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// How far and how well one marking is seen in one image.
struct MarkingSight {
  double begin = 0;    ///< [m] first paint
  double end = 0;      ///< [m] last paint in front of a gap that no dashed marking has
  double support = 0;  ///< part of the windows up to `end` in which paint was found
  int found = 0;       ///< windows with paint, up to `end`
  int open = 0;        ///< windows with bars of which none fitted
};

MarkingSight judge_marking(const EdgeSearch& search, const LaneFilter::Fit& fit, Side side);

/// Tells the memories of the left and right marking what the windows showed.
void remember_paint(const EdgeSearch& search, const LaneFilter::Fit& fit, std::array<PaintMemory, 2>& paint);

/// For pictures.
void list_windows(const EdgeSearch& search, const LaneFilter::Fit& fit, std::vector<SearchWindow>& windows);

}  // namespace lanefuse
