// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sensors/camera_intrinsics.hpp"

namespace lanefuse {

enum class SensorKind : std::uint8_t {
  odometry = 0,
  serial_camera = 1,
  high_resolution_camera = 2,
  long_range_radar = 3,
  short_range_radar = 4,
  object_fusion = 5,  ///< a production fusion that hands over tracked objects
  gnss_ins = 6,
  camera = 7,  ///< one camera whose images serve both as the serial and as the high-resolution camera's
  object_camera = 8,  ///< a camera that hands over boxes of vehicles; `camera` describes its lens
};
const char* to_string(SensorKind kind);

/// Where a sensor sits: the pose of its frame in the vehicle frame (ISO 8855, origin at road height under the
/// middle of the front axle). Metres and radians; roll, pitch, yaw turn about x, y, z in the order yaw,
/// pitch, roll.
struct Mounting {
  double x = 0;
  double y = 0;
  double z = 0;
  double roll = 0;
  double pitch = 0;
  double yaw = 0;
  friend bool operator==(const Mounting&, const Mounting&) = default;
};

struct SensorDescription {
  std::uint32_t id = 0;  ///< unique in the rig; measurements refer to it
  SensorKind kind = SensorKind::odometry;
  std::string name;
  Mounting mounting;
  std::optional<CameraIntrinsics> camera = {};  ///< of cameras that hand over images or boxes
  friend bool operator==(const SensorDescription&, const SensorDescription&) = default;
};

/// The sensors of a car: recorded once, in front of the measurements.
struct Rig {
  std::vector<SensorDescription> sensors;

  [[nodiscard]] const SensorDescription* find(std::uint32_t id) const;
  [[nodiscard]] bool has_camera() const;
  friend bool operator==(const Rig&, const Rig&) = default;
};

}  // namespace lanefuse
