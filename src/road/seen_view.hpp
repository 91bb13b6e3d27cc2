// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/feature.hpp"
#include "core/lane_estimate.hpp"
#include "core/pose2.hpp"
#include "road/road_state.hpp"

namespace lanefuse {

/// Put a cycle's measurements into its debug view, in the vehicle frame of now: which line each was given to,
/// and as outliers those that were given to none. Once the view has held as many, nothing is allocated.

/// Paint: `given_to` names each feature's line, 0 for none.
void show_paint(const FeatureSet& set, const Pose2& now_from_measured,
                std::span<const std::uint64_t> given_to, DebugView& view);
/// Vehicles: their features are given to the lines beside them as long as they keep to their lane.
void show_vehicles(const FeatureSet& set, const Pose2& now_from_measured,
                   std::span<const RoadVehicle> vehicles, DebugView& view);
/// A tracked lane: four places of each clothoid, whose line `given_to` names.
void show_tracked_lane(const FeatureSet& set, const Pose2& now_from_measured,
                       std::span<const std::uint64_t> given_to, DebugView& view);

}  // namespace lanefuse
