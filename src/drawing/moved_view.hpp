// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lane_estimate.hpp"
#include "core/pose2.hpp"

namespace lanefuse {

/// The estimate as it is `seconds` later (below zero: earlier): the road stands, the car has moved on with
/// the estimate's own speed and yaw rate. Points move
/// with it, and are taken again every kPointSpacing. Covariances stay as they are: the time is short.
LaneEstimate moved_by(const LaneEstimate& estimate, double seconds);

/// Fused features, switches and road course, seen from a frame that has moved by `old_from_new`.
DebugView moved_by(const DebugView& debug, const Pose2& old_from_new);

}  // namespace lanefuse
