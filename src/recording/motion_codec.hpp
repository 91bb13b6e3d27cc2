// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// Speed and yaw rate as osi3.HostVehicleData; what the measurement lacks is absent from the message.
mcap::Bytes encode_motion(const VehicleMotion& motion);
VehicleMotion decode_motion(std::span<const std::byte> bytes, const Stamp& stamp);

/// Wheel speeds, which must be there, as lanefuse.v1.WheelSpeeds.
mcap::Bytes encode_wheel_speeds(const VehicleMotion& motion);
VehicleMotion decode_wheel_speeds(std::span<const std::byte> bytes, const Stamp& stamp);

}  // namespace lanefuse
