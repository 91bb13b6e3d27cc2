// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/guard_rails.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// What stands in for the object list where the car fuses its objects itself: the long-range radar, the
/// short-range radars at the corners, and the camera that finds vehicles. Sensor ids 6 to 11.
///
/// `most_mirrors`: of vehicles mirrored in guard rails, a radar and scan; else the preset's. Throws a
/// configuration error where the preset has more short-range radars than the car has corners.
std::vector<std::unique_ptr<SensorModel>> detection_sensors(const SensorPreset& preset,
                                                            const std::shared_ptr<const GuardRails>& rails,
                                                            std::optional<int> most_mirrors,
                                                            std::uint64_t seed);

/// ", detections" and, where they are said, the mirrors: for a drive's name.
std::string detections_in_name(std::optional<int> most_mirrors);

}  // namespace lanefuse
