// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "core/time.hpp"
#include "recording/mcap_records.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// The rig as lanefuse.v1.Rig. Reading throws Error (input) where an id stands twice or a mounting is not
/// finite.
mcap::Bytes encode_rig(const Rig& rig);
Rig decode_rig(std::span<const std::byte> bytes);

/// The same mountings as foxglove.FrameTransforms from "vehicle" to the sensors' names: for viewers, never
/// read back.
mcap::Bytes encode_transforms(const Rig& rig, Time time);

}  // namespace lanefuse
