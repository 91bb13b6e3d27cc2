// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "drawing/svg.hpp"
#include "drawing/track_history.hpp"

namespace lanefuse {

/// All tracks of a drive in one picture: how far ahead each was over time, and below it how far to the left.
/// A line is an id, thick while it bears witness of its lane, thin while it drives without, grey while it
/// stands; labels say the id and how long it was kept, wherever there is room for them.
Figure draw_tracks(const std::string& title, const TrackHistory& history);

}  // namespace lanefuse
