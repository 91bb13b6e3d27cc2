// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "recording/mcap_records.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// What a camera saw as lanefuse.v1.CameraView.
mcap::Bytes encode_camera_view(const CameraView& view);
/// Throws Error (input) where the bytes are no such message.
CameraView decode_camera_view(std::span<const std::byte> bytes);

}  // namespace lanefuse
