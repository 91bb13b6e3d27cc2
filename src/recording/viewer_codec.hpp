// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lane_estimate.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse {

/// A cycle in the terms of other people's tools. Written, never read back.

/// The boundaries as osi3.SensorData: points as sampled (at most 2 m apart), their lateral sigma as
/// `boundary_line_rmse.y`, in the vehicle frame; and the lanes between them, with their middles.
mcap::Bytes encode_detected_boundaries(const LaneEstimate& estimate);

/// The cycle as a drawing, foxglove.SceneUpdate in frame "vehicle": boundaries as line strips, fused features
/// as cubes coloured by source (outliers grey), the road course, and the smoothing edges that are switched
/// off.
mcap::Bytes encode_scene(const LaneEstimate& estimate, const DebugView& view);

/// A change of the estimate's status as foxglove.Log.
mcap::Bytes encode_status(const LaneEstimate& estimate);

}  // namespace lanefuse
