// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/settings.hpp"

#include <utility>

#include "pipeline/image_settings.hpp"
#include "pipeline/road_settings.hpp"
#include "pipeline/settings_section.hpp"
#include "pipeline/trust_settings.hpp"

namespace lanefuse {
namespace {

using Range = std::pair<double, double>;
constexpr Range kMetres{0.0, 1000.0};
constexpr Range kSigma{1e-9, 1000.0};
constexpr Range kDegrees{1e-6, 180.0};
constexpr Range kShare{0.0, 1.0};

void add_general(const Section& s, PerceptionConfig& c) {
  s.add("estimator", c.estimator, {"graph", "road"},
        "what fuses: the paper's graph, or the road-level estimator");
  s.add("cycle_hz", c.cycle_hz, {1.0, 100.0}, "Hz", "cycles a second of recorded time");
  s.add("reorder_window_s", c.reorder_window_s, {0.0, 2.0}, "s",
        "measurements older than this at their cycle are dropped");
  s.add("silence_s", c.silence_s, {0.05, 60.0}, "s",
        "a source that has spoken and is silent this long is unavailable");
  s.add("max_objects", c.max_objects, {1U, 4096U}, "",
        "objects or detections in one message; more are dropped");
}

void add_width(const Section& s, LaneWidth& width) {
  s.add("lane_width", width.mean, {2.0, 6.0}, "m", "of a lane where no camera measures it");
  s.add("lane_width_sigma", width.standard_deviation, {0.01, 2.0}, "m", "and how uncertain that is");
}

void add_odometry(const Section& s, DeadReckoningConfig& c) {
  s.add("history_s", c.history_s, {0.5, 60.0}, "s", "motion kept for measurements that arrive late");
  s.add("gap_s", c.gap_s, {0.05, 5.0}, "s", "without motion after which the path starts anew");
  const Section bias = s.section("bias");
  bias.add("start_sigma_deg", c.bias.start_sigma_deg, kDegrees, "deg/s",
           "gyro bias before anything is known");
  bias.add("drift_deg", c.bias.drift_deg, {0.0, 1.0}, "deg/s/sqrt(s)", "random walk of the gyro bias");
  bias.add("wheel_mismatch_sigma", c.bias.wheel_mismatch_sigma, {0.0, 0.1}, "",
           "relative difference of the rear wheels' radii");
  bias.add("wheel_noise_deg", c.bias.wheel_noise_deg, kDegrees, "deg/s",
           "noise of the rear wheels' yaw rate in one message");
  bias.add("track_width", c.bias.track_width, {0.5, 3.0}, "m", "between the rear wheels");
  bias.add("standstill_speed", c.bias.standstill_speed, {0.0, 1.0}, "m/s",
           "below, the car stands and the gyro shows its bias");
}

void add_witness(const Section& s, WitnessConfig& c) {
  s.add(
      "rule", c.rule, {"radar_and_camera", "radar_only"},
      "sensors that must have verified a vehicle; a drive recorded without a camera sets radar_only itself");
  s.add("driver_sigma", c.driver_sigma, kSigma, "m", "drivers about the middle of their lane");
  s.add("driver_heading_deg", c.driver_heading_deg, kDegrees, "deg", "the same for their heading");
  s.add("confidence", c.confidence, kShare, "", "of each of a vehicle's two features");
  s.add("min_speed", c.min_speed, {0.0, 50.0}, "m/s", "slower vehicles are no witnesses");
  s.add("max_heading_deg", c.max_heading_deg, kDegrees, "deg", "vehicles turned further are no witnesses");
  s.add("range_begin", c.range_begin, {-200.0, 200.0}, "m", "witnesses are at least this far ahead");
  s.add("range_max", c.range_max, kMetres, "m", "and at most this far");
  add_width(s, c.default_width);
}

void add_tracker(const Section& s, ObjectTrackerConfig& c) {
  s.add("acceleration_along", c.acceleration_along, kSigma, "m/s^2/sqrt(Hz)",
        "process noise along the motion");
  s.add("acceleration_across", c.acceleration_across, kSigma, "m/s^2/sqrt(Hz)",
        "process noise across the motion");
  s.add("wander_sigma", c.wander_sigma, kSigma, "m", "wander of the reflecting point across the rear");
  s.add("wander_tau", c.wander_tau, {0.01, 100.0}, "s", "for which it stays where it is");
  s.add("scatter", c.scatter, kSigma, "m", "of single reflections across the rear");
  s.add("depth", c.depth, kSigma, "m", "of single reflections along the vehicle");
  s.add("start_sigma_across", c.start_sigma_across, kSigma, "m/s", "a new track's speed across the road");
  s.add("misalignment_deg", c.misalignment_deg, kDegrees, "deg", "that all of a sensor's looks share");
  s.add("ego_yaw_deg", c.ego_yaw_deg, kDegrees, "deg/sqrt(s)", "by which the dead reckoning turns away");
  s.add("gate", c.gate, {1.0, 1000.0}, "", "squared Mahalanobis distance of a sighting to its track");
  s.add("same_along", c.same_along, {0.0, 20.0}, "m",
        "reflections of one scan this near along the sight are one vehicle");
  s.add("same_across", c.same_across, {0.0, 10.0}, "m", "and this near across it");
  s.add("same_range_rate", c.same_range_rate, {0.0, 20.0}, "m/s", "and this like in range rate");
  s.add("hit_odds", c.hit_odds, {0.01, 20.0}, "", "log odds that a sighting adds to a track's existence");
  s.add("miss_share", c.miss_share, kShare, "", "of a miss's log odds that count");
  s.add("confirm_odds", c.confirm_odds, {-20.0, 20.0}, "", "log odds from which a track is reported");
  s.add("confirm_hits", c.confirm_hits, {1, 100}, "", "looks that must have seen it before");
  s.add("coast_s", c.coast_s, {0.0, 10.0}, "s", "a track lives on unseen where it should be seen");
  s.add("hidden_coast_s", c.hidden_coast_s, {0.0, 60.0}, "s", "the same where it is hidden");
  s.add("tentative_coast_s", c.tentative_coast_s, {0.0, 10.0}, "s", "the same before it is reported");
  s.add("verified_odds", c.verified_odds, {0.0, 20.0}, "",
        "log odds from which a kind of sensor verifies a track");
  s.add("refused_odds", c.refused_odds, {-20.0, 0.0}, "", "below which it does no longer");
  s.add("min_speed", c.min_speed, {0.0, 50.0}, "m/s", "over ground: slower, a track stands");
  s.add("change_speed", c.change_speed, {0.01, 10.0}, "m/s",
        "across the road, from which a vehicle changes lane");
  s.add("change_s", c.change_s, {0.0, 10.0}, "s", "for which it must go on");
  s.add("window_s", c.window_s, {0.0, 1.0}, "s", "by which a look may come after later ones");
}

void add_radar(const Section& s, RadarConfig& c) {
  s.add("sigma_range", c.sigma_range, kSigma, "m", "of a reflection");
  s.add("sigma_bearing_deg", c.sigma_bearing_deg, kDegrees, "deg", "of a reflection");
  s.add("sigma_range_rate", c.sigma_range_rate, kSigma, "m/s", "of a reflection");
  s.add("range", c.range, kMetres, "m", "of its field");
  s.add("field_deg", c.field_deg, {0.1, 360.0}, "deg", "whole opening");
  s.add("near_range", c.near_range, kMetres, "m", "up to which it is wider");
  s.add("near_field_deg", c.near_field_deg, {0.1, 360.0}, "deg", "whole opening there");
  s.add("detection", c.detection, kShare, "", "probability that a vehicle in its field is in a scan");
}

void add_object_camera(const Section& s, ObjectCameraConfig& c) {
  s.add("sigma_edge_px", c.sigma_edge_px, {0.05, 100.0}, "px", "of a box's sides");
  s.add("sigma_base_px", c.sigma_base_px, {0.05, 100.0}, "px", "of its base line");
  s.add("sigma_pitch_deg", c.sigma_pitch_deg, kDegrees, "deg", "of the car in one image");
  s.add("sigma_yaw_deg", c.sigma_yaw_deg, kDegrees, "deg", "of the mounting");
  s.add("vehicle_width", c.vehicle_width, {0.5, 5.0}, "m", "where nothing else is known");
  s.add("vehicle_width_sigma", c.vehicle_width_sigma, kSigma, "m", "and how uncertain that is");
  s.add("range", c.range, kMetres, "m", "of its field");
  s.add("field_deg", c.field_deg, {0.1, 360.0}, "deg", "whole opening");
  s.add("detection", c.detection, kShare, "", "probability that it boxes a vehicle near the car");
  s.add("detection_far", c.detection_far, kShare, "", "the same at its range");
}

void add_sources(const Section& s, SourcesConfig& c) {
  add_odometry(s.section("odometry"), c.odometry);
  add_images(s.section("images"), c.images);
  const Section serial = s.section("serial_camera");
  serial.add("enabled", c.serial_camera.enabled, "whether the serial camera's lanes are used");
  serial.add("marking_width", c.serial_camera.marking_width, {0.05, 1.0}, "m",
             "of the paint where it is not measured");
  serial.add("covariance_inflation", c.serial_camera.covariance_inflation, {0.01, 1000.0}, "",
             "factor on its covariance");
  const Section high = s.section("high_resolution_camera");
  high.add("enabled", c.high_resolution_camera.enabled, "whether its marking features are used");
  high.add("range_max", c.high_resolution_camera.range_max, kMetres, "m",
           "features further ahead are dropped");
  const Section objects = s.section("objects");
  objects.add("enabled", c.objects.enabled, "whether other vehicles are used as witnesses");
  add_witness(objects.section("witness"), c.objects.witness);
  add_tracker(objects.section("tracker"), c.objects.tracker);
  add_radar(objects.section("long_range_radar"), c.objects.sensors.long_range_radar);
  add_radar(objects.section("short_range_radar"), c.objects.sensors.short_range_radar);
  add_object_camera(objects.section("camera"), c.objects.sensors.camera);
  add_trust_settings(objects.section("trust"), c.objects.trust);
  add_alignment_settings(objects.section("alignment"), c.objects.alignment);
  const Section ego = s.section("ego_path");
  ego.add("enabled", c.ego_path.enabled,
          "whether the car itself bears witness of its lane; not in the paper");
  ego.add("driver_sigma", c.ego_path.driver_sigma, kSigma, "m", "its driver about the middle of the lane");
  ego.add("driver_heading_deg", c.ego_path.driver_heading_deg, kDegrees, "deg", "the same for the heading");
  ego.add("confidence", c.ego_path.confidence, kShare, "", "of each of its two features");
  ego.add("min_speed", c.ego_path.min_speed, {0.0, 50.0}, "m/s", "slower, the car is no witness");
  add_width(ego, c.ego_path.default_width);
  add_lane_segmentation(s.section("lane_segmentation"), c.lane_segmentation);
}

void add_association(const Section& s, AssociationConfig& c) {
  s.add("along", c.along, {0.01, 2.0}, "m", "gate along the feature's heading");
  s.add("across", c.across, {0.01, 5.0}, "m", "gate across it, at the car");
  s.add("across_per_metre", c.across_per_metre, {0.0, 0.1}, "m/m", "more across, the further ahead");
  s.add("heading_deg", c.heading_deg, kDegrees, "deg", "gate of the heading, plus twice the measured sigma");
}

void add_fusion(const Section& s, FusionConfig& c) {
  s.add("keyframe_distance", c.keyframe_distance, {0.1, 50.0}, "m", "driven between two poses of the window");
  s.add("drop_behind", c.drop_behind, kMetres, "m", "features further behind are forgotten");
  s.add("drop_beyond", c.drop_beyond, kMetres, "m", "features further ahead are forgotten");
  s.add("drop_lateral", c.drop_lateral, kMetres, "m", "features further to the side are forgotten");
  s.add("drop_age_s", c.drop_age_s, {1.0, 3600.0}, "s", "features not measured for this long are forgotten");
  s.add("sample_spacing", c.sample_spacing, {0.5, 20.0}, "m",
        "between the samples of a serial camera's clothoid");
  s.add("sigma_along", c.sigma_along, kSigma, "m", "of every measurement along the marking, at least");
  s.add("confidence_gain", c.confidence_gain, kShare, "",
        "share of a measurement's confidence that a feature takes over");
  s.add("smoothing_edges", c.smoothing_edges, "tie successive features of a track");
  s.add("smoothing_sigma", c.smoothing_sigma, kSigma, "m", "how closely");
  s.add("smoothing_heading_deg", c.smoothing_heading_deg, kDegrees, "deg", "how closely in heading");
  s.add("width_edges", c.width_edges, "tie the two features of a vehicle by the lane's width");
  s.add("width_sigma", c.width_sigma, kSigma, "m", "how closely, beside the width's own uncertainty");
  s.add("width_heading_deg", c.width_heading_deg, kDegrees, "deg", "how closely in heading");
  s.add("switchable", c.switchable, "let smoothing edges switch off");
  s.add("switch_prior", c.switch_prior, {1e-3, 1e6}, "",
        "squared error from which a smoothing edge starts to switch off");
  s.add("max_features", c.max_features, {16U, 1000000U}, "",
        "of the window; when it is nearly full, the least informative are forgotten");
  s.add("max_measurements", c.max_measurements, {64U, 16000000U}, "", "of the window's features, likewise");
  s.add("max_ties", c.max_ties, {16U, 1000000U}, "", "between the window's features, likewise");
  add_association(s.section("association"), c.association);
  const Section odometry = s.section("odometry");
  odometry.add("speed_scale", c.odometry.speed_scale, kSigma, "", "relative error of the speed");
  odometry.add("yaw_rate_white", c.odometry.yaw_rate_white, kSigma, "deg/sqrt(s)", "noise of the yaw rate");
  odometry.add("yaw_rate_bias", c.odometry.yaw_rate_bias, {0.0, 10.0}, "deg/s", "bias left in the yaw rate");
  odometry.add("slip", c.odometry.slip, {0.0, 1.0}, "m/m", "sideways slip a metre driven");
  const Section solver = s.section("solver");
  solver.add("max_iterations", c.solver.max_iterations, {1, 1000}, "", "Gauss-Newton iterations a cycle");
  solver.add("relative_tolerance", c.solver.relative_tolerance, {0.0, 1.0}, "",
             "stop when the cost falls by less");
  solver.add("cg_tolerance", c.solver.cg_tolerance, {1e-12, 0.5}, "",
             "conjugate gradients end at this share of the first residual");
  solver.add("max_cg_iterations", c.solver.max_cg_iterations, {0, 10000}, "",
             "of conjugate gradients a step; beyond, the direct solver takes over");
  solver.add("switch_form", c.solver.switch_form, {"linear", "squared"},
             "how a switch enters the cost: s J or s^2 J");
}

void add_lanes(const Section& s, LaneModelConfig& c) {
  const Section base = s.section("base");
  base.add("fit", c.base.fit, {"heading", "joint"},
           "fit the road's course to headings (the paper's) or to positions, too");
  base.add("range_begin", c.base.range_begin, {-200.0, 200.0}, "m", "features further behind do not count");
  base.add("range_end", c.base.range_end, kMetres, "m", "features further ahead do not count");
  base.add("outlier_cut", c.base.outlier_cut, {1.0, 100.0}, "",
           "residuals above this many robust sigmas are cut");
  base.add("max_iterations", c.base.max_iterations, {0, 100}, "", "of fitting and cutting");
  base.add("min_features", c.base.min_features, {3U, 1000U}, "", "fewer make no road course");
  base.add("curvature_sigma", c.base.curvature_sigma, kSigma, "1/m", "weak prior");
  base.add("curvature_rate_sigma", c.base.curvature_rate_sigma, {1e-12, 1.0}, "1/m^2", "weak prior");
  base.add("heading_sigma_deg", c.base.heading_sigma_deg, kDegrees, "deg",
           "of a fully confident feature's heading, before the fit shows it");
  base.add("position_sigma", c.base.position_sigma, kSigma, "m", "of a fully confident feature's position");
  base.add("correlation", c.base.correlation, {1.0, 1000.0}, "",
           "features of paint that count as one in the covariance");
  base.add("track_correlation", c.base.track_correlation, {1.0, 1000.0}, "",
           "features of a vehicle's trail that do");
  s.add("group_gate", c.group_gate, {0.1, 5.0}, "m", "features further from every boundary are left over");
  s.add("birth_range", c.birth_range, kMetres, "m", "leftovers nearer than this may found a boundary");
  s.add("birth_window", c.birth_window, {0.01, 5.0}, "m", "across within which they must lie");
  s.add("birth_features", c.birth_features, {1U, 1000U}, "", "how many they must be");
  s.add("birth_confidence", c.birth_confidence, kShare, "",
        "of each of them that no tracked vehicle witnessed");
  s.add("birth_sigma", c.birth_sigma, kSigma, "m", "of the offset of a boundary just founded");
  s.add("birth_distance", c.birth_distance, {0.1, 10.0}, "m", "to the nearest boundary, at least");
  s.add("keep_features", c.keep_features, {1U, 1000U}, "", "such features that keep a boundary alive");
  s.add("max_misses", c.max_misses, {0U, 10000U}, "",
        "cycles without them after which a boundary is forgotten");
  s.add("merge_distance", c.merge_distance, {0.0, 10.0}, "m",
        "a boundary this near to an older one is forgotten");
  s.add("lane_width_min", c.lane_width_min, {1.0, 10.0}, "m", "narrower gaps are no lane");
  s.add("lane_width_max", c.lane_width_max, {1.0, 20.0}, "m", "wider gaps are no lane");
  s.add("range_max", c.range_max, {10.0, 500.0}, "m", "no boundary speaks further");
  s.add("sigma_max", c.sigma_max, {0.05, 100.0}, "m", "nor where its lateral sigma exceeds this");
  s.add("offset_range", c.offset_range, {1.0, 1000.0}, "m",
        "at which a feature counts half as much for a boundary's offset as beside the car");
  s.add("process_offset", c.process_offset, kSigma, "m", "process noise a 2.4 m driven");
  s.add("process_heading", c.process_heading, kSigma, "rad", "process noise a 2.4 m driven");
  s.add("process_curvature", c.process_curvature, kSigma, "1/m", "process noise a 2.4 m driven");
  s.add("process_curvature_rate", c.process_curvature_rate, kSigma, "1/m^2", "process noise a 2.4 m driven");
  s.add("measured_offset", c.measured_offset, kSigma, "m", "a fit's offset is never better");
  s.add("measured_heading", c.measured_heading, kSigma, "rad", "a fit's heading is never better");
  s.add("measured_curvature", c.measured_curvature, kSigma, "1/m", "a fit's curvature is never better");
  s.add("measured_curvature_rate", c.measured_curvature_rate, kSigma, "1/m^2",
        "a fit's curvature rate is never better");
}

}  // namespace

std::vector<Setting> settings_of(PerceptionConfig& config) {
  std::vector<Setting> settings;
  const Section root(settings, "");
  add_general(root, config);
  add_sources(root.section("sources"), config.sources);
  add_fusion(root.section("fusion"), config.fusion);
  add_lanes(root.section("lanes"), config.lanes);
  add_road_settings(root.section("road"), config.road);
  return settings;
}

}  // namespace lanefuse
