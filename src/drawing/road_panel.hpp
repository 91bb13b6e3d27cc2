// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "drawing/canvas.hpp"
#include "drawing/overlay.hpp"
#include "drawing/overlay_legend.hpp"

namespace lanefuse {

/// The road from above, to scale: x forward to the right, y left upwards; with fused features, boundaries and
/// vehicles. As high as `config` needs at the width that it is given.
void draw_road_panel(Canvas& canvas, const Box& box, const OverlayScene& scene, const OverlayConfig& config);
double road_panel_height(double width, const OverlayConfig& config);

std::vector<OverlayLegendEntry> road_panel_legend();

}  // namespace lanefuse
