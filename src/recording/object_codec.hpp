// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "recording/mcap_records.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// Tracked vehicles as osi3.SensorData.
///
/// OSI places an object by the middle of its box, gives velocities relative to the host and has standard
/// deviations in place of covariances. Its fields are filled by its rules as far as a list knows them
/// (`base.position`, `orientation`, `dimension`, `base_rmse`; no velocity), and the rear, the speed over
/// ground and the full covariance travel beside them in `lanefuse_rear`, from which they are read back
/// exactly. `radar_specifics` and `camera_specifics` are there if such a sensor has verified the object.
///
/// Throws Error (input) for an id below zero, and on reading for an object without `lanefuse_rear`.
mcap::Bytes encode_objects(const ObjectList& list);
ObjectList decode_objects(std::span<const std::byte> bytes, const Stamp& stamp);

}  // namespace lanefuse
