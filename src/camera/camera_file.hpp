// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "sensors/rig.hpp"

namespace lanefuse {

/// Reads a camera.yaml: a camera's lens, chip and mounting. docs/camera-calibration.md describes every key.
/// The sensor's id is 0: the rig that takes it in gives it one.
///
/// A key that is missing or unknown, a value of the wrong kind, not finite or out of its range is refused
/// with a configuration Error that names file, line and key.
SensorDescription load_camera(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in errors.
SensorDescription parse_camera(const std::string& yaml, const std::string& name);

/// The camera as YAML that load_camera() reads back, numbers to the last bit (angles to rounding). Only for
/// cameras: `camera.camera` must be there.
std::string to_yaml(const SensorDescription& camera);

}  // namespace lanefuse
