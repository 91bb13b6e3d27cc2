// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "core/time.hpp"
#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// An image as foxglove.CompressedImage: its bytes as the camera sent them, whatever they hold.
mcap::Bytes encode_camera_image(const CameraImage& image);
/// Throws Error (input) where the bytes are no such message.
CameraImage decode_camera_image(std::span<const std::byte> bytes, const Stamp& stamp);

/// The lens of a camera of the rig as foxglove.CameraCalibration: for viewers, never read back. `sensor` must
/// have one.
mcap::Bytes encode_camera_calibration(const SensorDescription& sensor, Time time);

}  // namespace lanefuse
