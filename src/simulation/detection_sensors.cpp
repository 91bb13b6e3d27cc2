// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/detection_sensors.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/camera_boxes_model.hpp"
#include "simulation/radar_model.hpp"

namespace lanefuse {

std::vector<std::unique_ptr<SensorModel>> detection_sensors(const SensorPreset& preset,
                                                            const std::shared_ptr<const GuardRails>& rails,
                                                            std::optional<int> most_mirrors,
                                                            std::uint64_t seed) {
  if (preset.short_range_radar.count > kCorners) {
    throw configuration_error("preset", fmt::format("{} short-range radars: the car has {} corners",
                                                    preset.short_range_radar.count, kCorners));
  }
  std::vector<RadarModel::Setup> radars{long_range_radar_setup(preset, rails)};
  for (int corner = 0; corner < preset.short_range_radar.count; ++corner) {
    radars.push_back(short_range_radar_setup(preset, rails, corner));
  }
  std::vector<std::unique_ptr<SensorModel>> sensors;
  for (RadarModel::Setup& radar : radars) {
    if (most_mirrors) {
      const double most = *most_mirrors;
      radar.mirrors = {std::min(radar.mirrors.low, most), most};
    }
    sensors.push_back(std::make_unique<RadarModel>(radar, seed));
  }
  sensors.push_back(std::make_unique<CameraBoxesModel>(preset, seed));
  return sensors;
}

std::string detections_in_name(std::optional<int> most_mirrors) {
  std::string name = ", detections";
  if (most_mirrors) name += fmt::format(", up to {} guard-rail mirrors", *most_mirrors);
  return name;
}

}  // namespace lanefuse
