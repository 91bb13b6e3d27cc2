// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "drawing/canvas.hpp"
#include "drawing/overlay.hpp"
#include "drawing/overlay_legend.hpp"

namespace lanefuse {

/// The image with the bars of paint, the search windows and the vehicles that were found in it, and with the
/// lane boundaries projected onto its road.
void draw_camera_panel(Canvas& canvas, const Box& box, const OverlayScene& scene);

std::vector<OverlayLegendEntry> camera_panel_legend(const OverlayScene& scene);

}  // namespace lanefuse
