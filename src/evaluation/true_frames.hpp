// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "core/time.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// Frames further apart than this are a gap in the truth, and nothing is made up between them.
inline constexpr Duration kLargestFrameGap = std::chrono::seconds(1);

/// Where everything truly was at `time`: the frame of that very time, else between the frames around it, with
/// poses on the arc between theirs and with those objects that both have. `frames` are in order of time.
/// Nothing outside of the frames and in gaps between them.
std::optional<TrueFrame> frame_at(std::span<const TrueFrame> frames, Time time);

}  // namespace lanefuse
