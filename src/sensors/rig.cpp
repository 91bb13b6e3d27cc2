// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sensors/rig.hpp"

#include <algorithm>

namespace lanefuse {

const SensorDescription* Rig::find(std::uint32_t id) const {
  const auto found =
      std::find_if(sensors.begin(), sensors.end(), [id](const auto& sensor) { return sensor.id == id; });
  return found == sensors.end() ? nullptr : &*found;
}

bool Rig::has_camera() const {
  return std::any_of(sensors.begin(), sensors.end(), [](const auto& sensor) {
    return sensor.kind == SensorKind::serial_camera || sensor.kind == SensorKind::high_resolution_camera ||
           sensor.kind == SensorKind::camera || sensor.kind == SensorKind::object_camera;
  });
}

const char* to_string(SensorKind kind) {
  switch (kind) {
    case SensorKind::odometry:
      return "odometry";
    case SensorKind::serial_camera:
      return "serial_camera";
    case SensorKind::high_resolution_camera:
      return "high_resolution_camera";
    case SensorKind::long_range_radar:
      return "long_range_radar";
    case SensorKind::short_range_radar:
      return "short_range_radar";
    case SensorKind::object_fusion:
      return "object_fusion";
    case SensorKind::gnss_ins:
      return "gnss_ins";
    case SensorKind::camera:
      return "camera";
    case SensorKind::object_camera:
      return "object_camera";
  }
  return "unknown";
}

}  // namespace lanefuse
