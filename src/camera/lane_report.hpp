// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "camera/lane_filter.hpp"
#include "camera/lane_tracker.hpp"
#include "core/feature.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// One inner edge as the filter knows it, with a covariance that counts in what the pose does not know. Its
/// range, marking and confidence are left open.
ClothoidMeasurement measured_edge(const LaneFilter& filter, Side side, const CameraPose& pose);

/// Writes the filter's numbers into the track.
void write_state(const Gaussian<LaneState::kSize>& state, LaneTrack& track);

}  // namespace lanefuse
