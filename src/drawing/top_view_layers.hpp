// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "drawing/axes.hpp"
#include "drawing/legend.hpp"
#include "drawing/top_view.hpp"

/// The layers of a top view, from back to front. See draw_top_view().
namespace lanefuse {

inline constexpr double kViewFrom = -6;  ///< [m] so that the ego vehicle is seen
inline constexpr double kViewTo = 130;   ///< [m]

/// Names what the view shows, and nothing else.
std::vector<LegendEntry> top_view_legend(const TopView& view);

/// The ego lane as a wash, each boundary with its band of one sigma, faded where it no longer speaks.
void draw_lanes(SvgWriter& svg, const Axes& axes, const LaneEstimate& estimate);
void draw_truth(SvgWriter& svg, const Axes& axes, const TopView& view);
/// Smoothing edges: thin where they hold, dashed red where they are switched off.
void draw_switches(SvgWriter& svg, const Axes& axes, const DebugView& debug);
void draw_base_clothoid(SvgWriter& svg, const Axes& axes, const DebugView& debug);
/// Coloured by source where the road course used them, magenta as outliers, small where they took no part.
void draw_features(SvgWriter& svg, const Axes& axes, const DebugView& debug);
/// The ego vehicle and those around it, to scale in each axis.
void draw_vehicles(SvgWriter& svg, const Axes& axes, const TopView& view);

}  // namespace lanefuse
