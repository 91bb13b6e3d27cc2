// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pose2.hpp"
#include "drawing/svg.hpp"
#include "drawing/top_view.hpp"
#include "evaluation/error_trace.hpp"

namespace lanefuse {

/// The whole way that was driven, coloured (and thickened) by the ego lane's error 60 m ahead; turned so that
/// it fills the picture. However long the drive, it has 300 places at most, each with the RMS around it.
Figure draw_drive_map(const ErrorTrace& trace);

/// One moment on the map, to scale, north up: estimated boundaries in red, true ones in blue, the car as a
/// cross [IROS16, fig. "Aerial view"].
Figure draw_on_map(const TopView& view, const Pose2& world_from_vehicle);

}  // namespace lanefuse
