// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// The vehicles of one image as lanefuse.v1.CameraBoxes. Numbers that are not finite pass: their source
/// rejects them.
mcap::Bytes encode_camera_boxes(const CameraBoxes& boxes);
CameraBoxes decode_camera_boxes(std::span<const std::byte> bytes, const Stamp& stamp);

}  // namespace lanefuse
