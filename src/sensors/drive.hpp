// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sensors/geo_origin.hpp"

namespace lanefuse {

/// Which sensors must have verified a vehicle before it may bear witness of a lane.
enum class WitnessRule : std::uint8_t {
  radar_and_camera = 0,  ///< the paper's rule [IROS16, sec. II-C]
  radar_only = 1,        ///< for drives without a camera; set openly and named in every report
};
const char* to_string(WitnessRule rule);

/// What is said of a whole drive, in the metadata of its recording.
struct DriveInfo {
  std::string name;         ///< says where it comes from: "simulated, seed 1", "comma2k19 .../40"
  std::string preset_hash;  ///< of the sensor preset that made it, empty for real drives
  WitnessRule witness = WitnessRule::radar_and_camera;
  std::optional<GeoOrigin> origin = {};  ///< of the truth's world frame, where that is known
  bool images = false;  ///< some camera hands over images; a recording of it says so by itself
  friend bool operator==(const DriveInfo&, const DriveInfo&) = default;
};

}  // namespace lanefuse
