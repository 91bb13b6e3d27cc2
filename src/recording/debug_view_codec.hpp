// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "core/lane_estimate.hpp"
#include "recording/mcap_records.hpp"

namespace lanefuse {

/// The inside view of a cycle in three messages: lanefuse.v1.FusedFeatures, SwitchStates and RoadCourse. Each
/// decoder fills its part of `view`.
mcap::Bytes encode_fused_features(const DebugView& view);
mcap::Bytes encode_switches(const DebugView& view);
mcap::Bytes encode_road_course(const DebugView& view);

void decode_fused_features(std::span<const std::byte> bytes, DebugView& view);
void decode_switches(std::span<const std::byte> bytes, DebugView& view);
void decode_road_course(std::span<const std::byte> bytes, DebugView& view);

}  // namespace lanefuse
