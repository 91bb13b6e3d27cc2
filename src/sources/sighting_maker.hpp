// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "camera/camera_model.hpp"
#include "objects/sighting.hpp"
#include "sensors/measurement.hpp"
#include "sources/feature_source.hpp"

namespace lanefuse {

/// What is known of one kind of radar. The defaults are those of a usual long-range radar.
struct RadarConfig {
  double sigma_range = 0.25;       ///< [m]
  double sigma_bearing_deg = 0.2;  ///< [deg]
  double sigma_range_rate = 0.15;  ///< [m/s] with what wheels and the own speed's error add
  double range = 200;              ///< [m]
  double field_deg = 17;           ///< [deg] whole opening
  double near_range = 60;          ///< [m] up to which it is wider
  double near_field_deg = 56;      ///< [deg] whole opening
  double detection = 0.9;          ///< probability that a vehicle in its field is in a scan
};

inline RadarConfig short_range_radar_config() { return {0.2, 1.5, 0.15, 50, 150, 0, 150, 0.85}; }

/// A radar of which nobody knows more than that it is older than the paper's.
inline RadarConfig unknown_radar_config() { return {0.5, 0.5, 0.25, 180, 36, 0, 36, 0.8}; }

/// What is known of a camera that boxes vehicles.
struct ObjectCameraConfig {
  double sigma_edge_px = 1.5;        ///< [px] of a box's sides
  double sigma_base_px = 1.5;        ///< [px] of its base line
  double sigma_pitch_deg = 0.15;     ///< [deg] of the car in one image
  double sigma_yaw_deg = 0.1;        ///< [deg] of the mounting
  double vehicle_width = 1.9;        ///< [m]
  double vehicle_width_sigma = 0.3;  ///< [m]
  double range = 90;                 ///< [m]
  double field_deg = 44;             ///< [deg] whole opening
  double detection = 0.95;           ///< probability near the car
  double detection_far = 0.5;        ///< the same at `range`
};

struct SightingMakerConfig {
  RadarConfig long_range_radar;
  RadarConfig short_range_radar = short_range_radar_config();
  ObjectCameraConfig camera;
};

/// Turns what radars and cameras say, each in its own terms, into sightings over ground.
class SightingMaker {
 public:
  explicit SightingMaker(const SightingMakerConfig& config) : config_(config) {}

  /// Fills `look`; false where there is no such sensor in the rig, no lens for boxes, or no motion at the
  /// stamp. Implausible detections are left out; so are boxes above the horizon, and what lies outside of the
  /// sensor's field by far.
  bool make(const RadarScan& scan, const SourceContext& context, SightingSet& look) const;
  bool make(const CameraBoxes& boxes, const SourceContext& context, SightingSet& look);

 private:
  SightingMakerConfig config_;
  std::map<std::uint32_t, CameraModel> lenses_;

  const CameraModel& lens_of(const SensorDescription& sensor);
  [[nodiscard]] std::optional<Sighting> sighting_of(const BoxDetection& box, const SensorDescription& sensor,
                                                    const CameraModel& lens) const;
};

}  // namespace lanefuse
