// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/preset.hpp"

#include <fstream>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "simulation/preset_section.hpp"

namespace lanefuse {
namespace {

constexpr double kMilli = 1e-3;
constexpr double kDegree = std::numbers::pi / 180;

Range read_radius(PresetSection course) {
  const Range radius = course.range("radius_m");
  course.finish();
  return radius;
}

RoadPreset read_road(PresetSection road) {
  RoadPreset preset;
  preset.gentle_radius = read_radius(road.section("gentle"));
  preset.curved_radius = read_radius(road.section("curved"));
  preset.lanes = static_cast<int>(road.positive("lanes"));
  preset.lane_width = road.range("lane_width_m");
  preset.shoulder = road.number("shoulder_m");
  PresetSection width = road.section("marking_width_m");
  preset.dashed_marking_width = width.positive("dashed");
  preset.edge_marking_width = width.positive("edge");
  PresetSection dash = road.section("dash_m");
  preset.dash_mark = dash.positive("mark");
  preset.dash_gap = dash.number("gap");
  preset.guard_rail = road.number("guard_rail_m");
  PresetSection vertical = road.section("vertical_curvature");
  preset.vertical_curvature_sigma = vertical.number("sigma_1pm");
  preset.vertical_curvature_length = vertical.positive("length_m");
  for (const PresetSection& part : {width, dash, vertical, road}) part.finish();
  return preset;
}

EgoPreset read_ego(PresetSection ego) {
  EgoPreset preset;
  preset.speed = ego.positive("speed_mps");
  preset.lane_change_every = ego.positive("lane_change_every_s");
  ego.finish();
  return preset;
}

TrafficPreset read_traffic(PresetSection traffic) {
  TrafficPreset preset;
  preset.vehicles_per_metre_lane = traffic.number("vehicles_per_km_lane") * kMilli;
  preset.trucks = traffic.share("trucks");
  preset.wander_sigma = traffic.number("wander_sigma_m");
  preset.wander_tau = traffic.positive("wander_tau_s");
  preset.driver_bias = traffic.number("driver_bias_m");
  preset.lane_change_every = traffic.positive("lane_change_every_s");
  traffic.finish();
  return preset;
}

OdometryPreset read_odometry(PresetSection odometry) {
  OdometryPreset preset;
  preset.hz = odometry.positive("hz");
  preset.latency = odometry.number("latency_ms") * kMilli;
  preset.speed_scale = odometry.number("speed_scale");
  preset.yaw_rate_white = odometry.degrees("yaw_rate_white_dps");
  preset.yaw_rate_bias = odometry.degrees("yaw_rate_bias_dps");
  odometry.finish();
  return preset;
}

CameraPosePreset read_camera_pose(PresetSection pose) {
  CameraPosePreset preset;
  preset.height = pose.positive("height_m");
  preset.residual_pitch = pose.degrees("residual_pitch_deg");
  preset.residual_pitch_tau = pose.positive("residual_pitch_tau_s");
  preset.yaw_bias = pose.degrees("yaw_bias_deg");
  preset.yaw_bias_tau = pose.positive("yaw_bias_tau_s");
  pose.finish();
  return preset;
}

SerialCameraPreset read_serial_camera(PresetSection camera) {
  SerialCameraPreset preset;
  preset.hz = camera.positive("hz");
  preset.latency = camera.number("latency_ms") * kMilli;
  preset.pixel = camera.positive("pixel_mrad") * kMilli;
  preset.noise_px = camera.number("noise_px");
  preset.range_max = camera.positive("range_max_m");
  preset.range_mean = camera.positive("range_mean_m");
  preset.dropout = camera.share("dropout");
  camera.expect("tracker", "five-state Kalman filter");
  camera.finish();
  return preset;
}

HighResolutionCameraPreset read_high_resolution_camera(PresetSection camera) {
  HighResolutionCameraPreset preset;
  preset.hz = camera.positive("hz");
  preset.latency = camera.number("latency_ms") * kMilli;
  preset.pixel = camera.positive("pixel_mrad") * kMilli;
  preset.noise_px = camera.number("noise_px");
  preset.noise = camera.number("noise_m");
  preset.range_max = camera.positive("range_max_m");
  PresetSection detection = camera.section("detection");
  preset.detection_near = detection.share("near");
  preset.detection_at_130_m = detection.share("at_130_m");
  PresetSection heading = camera.section("heading_deg");
  preset.heading = {heading.degrees("base"), heading.degrees("at_100_m")};
  preset.shared_sigma_at_100_m = camera.number("frame_shared_sigma_at_100_m");
  preset.shared_tau = camera.positive("frame_shared_tau_s");
  preset.outliers = camera.share("outliers");
  preset.outliers_on_guard_rail = camera.share("outliers_on_guard_rail");
  for (const PresetSection& part : {detection, heading, camera}) part.finish();
  return preset;
}

ObjectListPreset read_object_list(PresetSection objects) {
  ObjectListPreset preset;
  preset.hz = objects.positive("hz");
  preset.latency = objects.number("latency_ms") * kMilli;
  preset.range_max = objects.positive("range_max_m");
  PresetSection sigma_y = objects.section("sigma_y_m");
  preset.sigma_y = {sigma_y.number("base"), sigma_y.number("at_100_m")};
  sigma_y.finish();
  preset.tau = objects.positive("tau_s");
  const Range heading = objects.range("heading_deg");
  preset.heading = {heading.low * kDegree, heading.high * kDegree};
  preset.misalignment = objects.degrees("misalignment_deg");
  objects.finish();
  return preset;
}

/// What both kinds of radar say.
RadarPreset read_radar(PresetSection& radar) {
  RadarPreset preset;
  preset.hz = radar.positive("hz");
  preset.latency = radar.number("latency_ms") * kMilli;
  preset.range = radar.positive("range_m");
  preset.field = radar.positive("field_deg") * kDegree;
  preset.sigma_range = radar.number("sigma_range_m");
  preset.sigma_azimuth = radar.degrees("sigma_azimuth_deg");
  preset.sigma_range_rate = radar.number("sigma_range_rate_mps");
  preset.detection = radar.share("detection");
  preset.reflections = radar.counts("reflections_per_vehicle");
  preset.clutter = radar.number("clutter_per_scan");
  return preset;
}

RadarPreset read_long_range_radar(PresetSection radar) {
  RadarPreset preset = read_radar(radar);
  preset.near_range = radar.number("near_range_m");
  preset.near_field = radar.degrees("near_field_deg");
  preset.misalignment = radar.degrees("misalignment_deg");
  radar.finish();
  return preset;
}

/// The file does not say how well they are aligned: as well as the long-range radar.
RadarPreset read_short_range_radar(PresetSection radar, double misalignment) {
  RadarPreset preset = read_radar(radar);
  preset.count = radar.count("count");
  preset.misalignment = misalignment;
  radar.finish();
  return preset;
}

CameraBoxesPreset read_camera_boxes(PresetSection boxes) {
  CameraBoxesPreset preset;
  preset.hz = boxes.positive("hz");
  preset.latency = boxes.number("latency_ms") * kMilli;
  preset.range = boxes.positive("range_m");
  preset.sigma_edge_px = boxes.number("sigma_edge_px");
  preset.sigma_base_px = boxes.number("sigma_base_px");
  PresetSection detection = boxes.section("detection");
  preset.detection_near = detection.share("near");
  preset.detection_at_90_m = detection.share("at_90_m");
  preset.false_boxes = boxes.number("false_per_frame");
  for (const PresetSection& part : {detection, boxes}) part.finish();
  return preset;
}

GhostsPreset read_ghosts(PresetSection ghosts) {
  const GhostsPreset preset{ghosts.counts("guard_rail_mirrors_per_scan")};
  ghosts.finish();
  return preset;
}

GnssInsPreset read_gnss_ins(PresetSection gnss_ins) {
  GnssInsPreset preset;
  preset.hz = gnss_ins.positive("hz");
  preset.position = gnss_ins.positive("position_m");
  preset.position_tau = gnss_ins.positive("position_tau_s");
  preset.heading = gnss_ins.positive("heading_deg") * kDegree;
  gnss_ins.finish();
  return preset;
}

SurveyedTruthPreset read_surveyed_truth(PresetSection truth) {
  truth.leave("exact");
  PresetSection surveyed = truth.section("surveyed");
  const SurveyedTruthPreset preset{surveyed.number("ego_m"), surveyed.number("adjacent_m"),
                                   surveyed.degrees("heading_deg")};
  for (const PresetSection& part : {surveyed, truth}) part.finish();
  return preset;
}

YAML::Node parse_yaml(std::string_view text, const std::string& place) {
  try {
    return YAML::Load(std::string(text));
  } catch (const YAML::Exception& error) {
    throw configuration_error(place, fmt::format("line {} is not YAML: {}", error.mark.line + 1, error.msg));
  }
}

}  // namespace

SensorPreset parse_preset(std::string_view text, const std::string& place) {
  PresetSection file(parse_yaml(text, place), place);
  SensorPreset preset;
  preset.hash = fmt::format("{:016x}", fnv1a(text));
  file.expect("version", "1");
  preset.road = read_road(file.section("road"));
  preset.ego = read_ego(file.section("ego"));
  preset.traffic = read_traffic(file.section("traffic"));
  preset.fusion_hz = file.positive("fusion_hz");
  preset.odometry = read_odometry(file.section("odometry"));
  preset.camera_pose = read_camera_pose(file.section("camera_pose"));
  preset.serial_camera = read_serial_camera(file.section("serial_camera"));
  preset.high_resolution_camera = read_high_resolution_camera(file.section("high_resolution_camera"));
  preset.object_list = read_object_list(file.section("object_list"));
  preset.long_range_radar = read_long_range_radar(file.section("long_range_radar"));
  preset.short_range_radar =
      read_short_range_radar(file.section("short_range_radar"), preset.long_range_radar.misalignment);
  preset.camera_boxes = read_camera_boxes(file.section("camera_boxes"));
  preset.ghosts = read_ghosts(file.section("ghosts"));
  preset.gnss_ins = read_gnss_ins(file.section("gnss_ins"));
  preset.surveyed_truth = read_surveyed_truth(file.section("truth"));
  file.leave("conventions");
  file.finish();
  return preset;
}

SensorPreset nominal_preset() { return parse_preset(nominal_preset_text(), "nominal-preset.yaml"); }

SensorPreset load_preset(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw configuration_error(path.string(), "cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return parse_preset(text, path.string());
}

}  // namespace lanefuse
