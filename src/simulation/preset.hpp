// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lanefuse {

/// How a simulated road, its traffic and its sensors behave: config/nominal-preset.yaml, in SI units and
/// radians. Results are comparable only under the same file, so its hash goes with every result. Which number
/// means what is said where it is used, in the models; here stand units and readings.

struct Range {
  double low = 0;
  double high = 0;
};

/// A standard deviation that grows linearly with the distance, through its values at 0 m and 100 m.
struct GrowingSigma {
  double base = 0;
  double at_100_m = 0;
  [[nodiscard]] double at(double distance) const { return base + (at_100_m - base) * distance / 100; }
};

struct RoadPreset {
  Range gentle_radius;  ///< [m]
  Range curved_radius;  ///< [m]
  int lanes = 0;
  Range lane_width;                      ///< [m] between marking centres; one for a whole drive
  double shoulder = 0;                   ///< [m] beyond the edge marking, on both sides
  double dashed_marking_width = 0;       ///< [m] of the paint
  double edge_marking_width = 0;         ///< [m] of the paint
  double dash_mark = 0;                  ///< [m]
  double dash_gap = 0;                   ///< [m]
  double guard_rail = 0;                 ///< [m] beyond the shoulder
  double vertical_curvature_sigma = 0;   ///< [1/m]
  double vertical_curvature_length = 0;  ///< [m] along which it forgets
};

struct EgoPreset {
  double speed = 0;              ///< [m/s] wished for
  double lane_change_every = 0;  ///< [s]
};

struct TrafficPreset {
  double vehicles_per_metre_lane = 0;  ///< [1/m]
  double trucks = 0;                   ///< share of all vehicles
  double wander_sigma = 0;             ///< [m]
  double wander_tau = 0;               ///< [s]
  double driver_bias = 0;              ///< [m] sigma over the drivers
  double lane_change_every = 0;        ///< [s] mean, a vehicle
};

struct OdometryPreset {
  double hz = 0;
  double latency = 0;         ///< [s]
  double speed_scale = 0;     ///< sigma over drives
  double yaw_rate_white = 0;  ///< [rad/s] sigma of a sample
  double yaw_rate_bias = 0;   ///< [rad/s] sigma over drives
};

struct CameraPosePreset {
  double height = 0;              ///< [m] above the road
  double residual_pitch = 0;      ///< [rad] sigma
  double residual_pitch_tau = 0;  ///< [s]
  double yaw_bias = 0;            ///< [rad] sigma
  double yaw_bias_tau = 0;        ///< [s]
};

struct SerialCameraPreset {
  double hz = 0;
  double latency = 0;     ///< [s]
  double pixel = 0;       ///< [rad] a pixel
  double noise_px = 0;    ///< sigma of an edge's column
  double range_max = 0;   ///< [m]
  double range_mean = 0;  ///< [m]
  double dropout = 0;     ///< probability a frame
};

struct HighResolutionCameraPreset {
  double hz = 0;
  double latency = 0;                 ///< [s]
  double pixel = 0;                   ///< [rad] a pixel
  double noise_px = 0;                ///< sigma of a row and of a column
  double noise = 0;                   ///< [m] sigma of the paint's own edges
  double range_max = 0;               ///< [m]
  double detection_near = 0;          ///< probability at 0 m
  double detection_at_130_m = 0;      ///< probability
  GrowingSigma heading;               ///< [rad]
  double shared_sigma_at_100_m = 0;   ///< [m] lateral, of all features of a frame
  double shared_tau = 0;              ///< [s]
  double outliers = 0;                ///< share of the features
  double outliers_on_guard_rail = 0;  ///< share of the outliers
};

struct ObjectListPreset {
  double hz = 0;
  double latency = 0;       ///< [s]
  double range_max = 0;     ///< [m]
  GrowingSigma sigma_y;     ///< [m]
  double tau = 0;           ///< [s]
  Range heading;            ///< [rad] sigma, one a track
  double misalignment = 0;  ///< [rad] sigma over drives
};

/// A radar at detection level. It sees its whole range in the angle `field`, and what is nearer than
/// `near_range` in the angle `near_field`; both are whole opening angles.
struct RadarPreset {
  double hz = 0;
  double latency = 0;           ///< [s]
  int count = 1;                ///< of radars of this kind
  double range = 0;             ///< [m]
  double field = 0;             ///< [rad]
  double near_range = 0;        ///< [m]; 0: there is no second field
  double near_field = 0;        ///< [rad]
  double sigma_range = 0;       ///< [m]
  double sigma_azimuth = 0;     ///< [rad]
  double sigma_range_rate = 0;  ///< [m/s]
  double detection = 0;         ///< probability a vehicle and scan
  Range reflections;            ///< whole numbers, of a detected vehicle in a scan
  double clutter = 0;           ///< mean detections a scan that belong to no vehicle
  double misalignment = 0;      ///< [rad] sigma over drives
};

struct CameraBoxesPreset {
  double hz = 0;
  double latency = 0;            ///< [s]
  double range = 0;              ///< [m]
  double sigma_edge_px = 0;      ///< of the left, right and upper edge
  double sigma_base_px = 0;      ///< of the lower edge
  double detection_near = 0;     ///< probability at 0 m
  double detection_at_90_m = 0;  ///< probability
  double false_boxes = 0;        ///< mean an image
};

struct GhostsPreset {
  Range guard_rail_mirrors;  ///< whole numbers: vehicles that a radar sees mirrored in a scan
};

/// The errors of the paper's own map, as its Table I shows them at 0 m: sigmas. The evaluation lays them on
/// the exact truth; no sensor knows of them.
struct SurveyedTruthPreset {
  double ego = 0;       ///< [m] across, boundaries of the ego lane
  double adjacent = 0;  ///< [m] across, outer boundaries of its neighbours
  double heading = 0;   ///< [rad] about the car
};

struct GnssInsPreset {
  double hz = 0;
  double position = 0;      ///< [m] sigma of each coordinate
  double position_tau = 0;  ///< [s]
  double heading = 0;       ///< [rad] sigma
};

struct SensorPreset {
  std::string hash;  ///< of the file's bytes: FNV-1a 64, sixteen hexadecimal digits
  /// All sigmas below are this many times those of the file, which are what sensors state: see with_noise().
  double noise = 1;
  RoadPreset road;
  EgoPreset ego;
  TrafficPreset traffic;
  double fusion_hz = 0;
  OdometryPreset odometry;
  CameraPosePreset camera_pose;
  SerialCameraPreset serial_camera;
  HighResolutionCameraPreset high_resolution_camera;
  ObjectListPreset object_list;
  RadarPreset long_range_radar;
  RadarPreset short_range_radar;
  CameraBoxesPreset camera_boxes;
  GhostsPreset ghosts;
  GnssInsPreset gnss_ins;
  SurveyedTruthPreset surveyed_truth;
};

/// The bytes of config/nominal-preset.yaml, as they were when the program was built.
std::string_view nominal_preset_text();

SensorPreset nominal_preset();

/// Reads a preset file. Throws a configuration error that names the key which is missing, unknown or no
/// number.
SensorPreset load_preset(const std::filesystem::path& path);

/// As load_preset; `place` names the text in errors.
SensorPreset parse_preset(std::string_view text, const std::string& place);

}  // namespace lanefuse
