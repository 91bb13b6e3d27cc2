// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/road_settings.hpp"

#include <string>
#include <utility>

namespace lanefuse {
namespace {

using Range = std::pair<double, double>;
constexpr Range kSigma{1e-9, 1000.0};
constexpr Range kDegrees{1e-6, 180.0};
constexpr Range kTime{0.01, 10000.0};

void add_wander_deg(const Section& s, WanderingError& error, const char* what) {
  s.add("sigma_deg", error.sigma, kDegrees, "deg", what);
  s.add("tau", error.tau, kTime, "s", "for which it stays what it is");
}

void add_course(const Section& s, RoadCourseConfig& c) {
  s.add("curvature_step", c.curvature_step, kSigma, "1/m",
        "change of the road's curvature over 20 m, at least");
  s.add("curvature_step_max", c.curvature_step_max, kSigma, "1/m",
        "and at most, where the road behind was that restless");
  s.add("persistence", c.persistence, {0.0, 0.99}, "", "share of such a change that the next 20 m repeat");
  s.add("churn", c.churn, {0.0, 10.0}, "",
        "share of that change by which 20 m driven make the course uncertain");
  s.add("habit", c.habit_m, {20.0, 100000.0}, "m", "of road behind that say how restless it is");
  s.add("first_curvature", c.first_curvature, kSigma, "1/m", "of the road before anything is known");
  s.add("first_heading_deg", c.first_heading_deg, kDegrees, "deg",
        "of the car along the road before anything is known");
  s.add("offset_step", c.offset_step, kSigma, "m", "by which a line leaves the others' direction over 40 m");
}

void add_motion(const Section& s, RoadMotionConfig& c) {
  s.add("heading_deg", c.heading_deg, kDegrees, "deg/sqrt(s)", "by which the dead reckoning turns away");
  s.add("slip", c.slip, kSigma, "m/sqrt(m)", "by which it goes aside");
  s.add("speed_scale", c.speed_scale, kSigma, "", "relative error of its speed");
  s.add("yaw_rate_bias_deg", c.yaw_rate_bias_deg, kDegrees, "deg/s", "left in its yaw rate");
  s.add("yaw_rate_drift_deg", c.yaw_rate_drift_deg, {0.0, 1.0}, "deg/s/sqrt(s)", "by which that changes");
}

void add_camera(const Section& s, CameraErrorsConfig& c) {
  s.add("height", c.height, {0.3, 5.0}, "m", "of the camera over the road");
  add_wander_deg(s.section("pitch"), c.pitch_deg, "of the body, frame by frame");
  add_wander_deg(s.section("yaw"), c.yaw_deg, "of the mounting");
  add_wander_deg(s.section("lean"), c.lean_deg, "by which all of a frame's lines lean together");
  s.add("vertical_curvature", c.vertical_curvature, kSigma, "1/m", "of the road's crests and sags");
  s.add("vertical_length", c.vertical_length, {1.0, 100000.0}, "m", "for which they last");
  s.add("pixel_mrad", c.pixel_mrad, kSigma, "mrad", "noise of a feature's row and column, at least");
  s.add("paint", c.paint, kSigma, "m", "and of its place across");
}

}  // namespace

void add_road_settings(const Section& s, RoadConfig& c) {
  s.add("range_order", c.range_order,
        "tell lines apart from near to far, else all by what the last frame left known");
  s.add("adapt_noise", c.adapt_noise, "learn from innovations how much sensors err");
  add_course(s.section("course"), c.course);
  add_motion(s.section("motion"), c.motion);
  add_camera(s.section("camera"), c.camera);
  const Section tracked = s.section("tracked_lane");
  tracked.add("inflation", c.tracked_lane.inflation, {1.0, 10000.0}, "",
              "factor on a tracked lane's covariance at 25 Hz, as its tracker repeats itself");
  add_wander_deg(tracked.section("yaw"), c.tracked_lane.yaw_deg, "of its camera's mounting");
  const Section vehicles = s.section("vehicles");
  vehicles.add("driver_sigma", c.vehicles.driver.sigma, kSigma, "m",
               "drivers about the middle of their lane");
  vehicles.add("driver_tau", c.vehicles.driver.tau, kTime, "s", "for which they stay where they are");
  vehicles.add("sensor_sigma", c.vehicles.sensor.sigma, kSigma, "m", "of tracks, across");
  vehicles.add("sensor_tau", c.vehicles.sensor.tau, kTime, "s", "for which a track errs the same way");
  vehicles.add("misalignment_deg", c.vehicles.misalignment_deg, kDegrees, "deg", "that all tracks share");
  vehicles.add("switchable", c.vehicles.switchable,
               "one that changes lane is not believed until it has settled");
  s.add("range_max", c.range_max, {10.0, 500.0}, "m", "no boundary speaks further");
  s.add("sigma_max", c.sigma_max, {0.05, 100.0}, "m", "nor where its lateral sigma exceeds this");
  s.add("usual_surprise", c.usual_surprise, {0.01, 100.0}, "",
        "mean square of innovations over their variances where noise is as assumed");
  s.add("height_error", c.height_error, {0.0, 0.2}, "",
        "of a camera's height, relative: scales what lies aside");
  s.add("bend_doubt", c.bend_doubt, {0.0, 1e6}, "m",
        "times the curvature's usual change over 20 m: share by which variances grow, as roads bend between "
        "knots");
  s.add("sigma_scale", c.sigma_scale, {0.1, 10.0}, "", "on the sigmas that are told");
  s.add("protection", c.protection, {1.0, 100.0}, "", "sigmas of the protection level");
}

}  // namespace lanefuse
