// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace lanefuse {

/// By what measurements are given to lines: by the gates of the filter, or by the labels of a simulation. The
/// latter is the oracle of a benchmark, and nothing that drives could have it.
enum class RoadAssociation : std::uint8_t { gated = 0, labelled = 1 };

/// An error that wanders about zero: its sigma, and the seconds for which it stays what it is.
struct WanderingError {
  double sigma = 0;
  double tau = 1;  ///< [s]
};

/// How the road itself may go on where nothing has been seen yet.
struct RoadCourseConfig {
  double curvature_step = 0.7e-4;  ///< [1/m] sigma of the curvature's change over one knot spacing, at least
  double curvature_step_max = 2e-3;  ///< [1/m] and at most, where the road behind was that restless
  double persistence = 0.8;          ///< share of a step that the next one repeats: clothoids are long
  double churn = 0.05;   ///< share of such a step by which a knot errs anew, over one spacing driven
  double habit_m = 600;  ///< [m] of road behind that say how restless it is
  double first_curvature = 1.5e-3;  ///< [1/m] sigma before anything is known
  double first_heading_deg = 2;     ///< [deg] the same of the car's heading along the road
  double offset_step = 0.03;        ///< [m] sigma of a marking's sideways drift over one offset spacing
};

/// What the car's dead reckoning errs by.
struct RoadMotionConfig {
  double heading_deg = 0.02;           ///< [deg/sqrt(s)] random walk of the heading
  double slip = 0.003;                 ///< [m/sqrt(m)] sideways
  double speed_scale = 0.005;          ///< relative error of the speed
  double yaw_rate_bias_deg = 0.05;     ///< [deg/s] left in the yaw rate
  double yaw_rate_drift_deg = 0.0005;  ///< [deg/s/sqrt(s)] by which that changes
};

/// What is wrong with a camera's view of the ground beside its pixels.
struct CameraErrorsConfig {
  double height = 1.25;                  ///< [m] of the camera, where it turns pitch into distance
  WanderingError pitch_deg{0.12, 0.3};   ///< [deg] of the body, from frame to frame
  WanderingError yaw_deg{0.12, 120};     ///< [deg] of the mounting
  WanderingError lean_deg{0.086, 0.5};   ///< [deg] by which all of a frame's lines lean together
  double vertical_curvature = 1.667e-5;  ///< [1/m] of the road
  double vertical_length = 250;          ///< [m] for which that holds
  double pixel_mrad = 0.8;               ///< [mrad] noise of a feature's row and column, at least
  double paint = 0.03;                   ///< [m] and of its place across
};

/// The serial camera's tracked lane, taken whole.
struct TrackedLaneConfig {
  double inflation = 60;  ///< on its covariance at 25 Hz: its tracker has counted everything before
  WanderingError yaw_deg{0.12, 120};  ///< [deg] of its mounting
};

/// Other vehicles as witnesses of the road's course.
struct VehiclesConfig {
  WanderingError driver{0.3, 25};   ///< [m] about the middle of the lane
  WanderingError sensor{0.3, 0.8};  ///< [m] of the tracks' places, shared by looks that follow each other
  double misalignment_deg = 0.08;   ///< [deg] that all tracks share
  bool switchable = true;           ///< one that changes lane is not believed until it has settled
};

/// Settings of the road-level estimator. Measured in docs/road.md.
struct RoadConfig {
  RoadAssociation association = RoadAssociation::gated;
  bool range_order = true;  ///< lines are told apart from near to far, else all by what the last frame left
  bool adapt_noise = true;  ///< how much sensors err is learned from innovations
  RoadCourseConfig course;
  RoadMotionConfig motion;
  CameraErrorsConfig camera;
  TrackedLaneConfig tracked_lane;
  VehiclesConfig vehicles;
  double range_max = 150;       ///< [m] no boundary speaks further
  double sigma_max = 2;         ///< [m] nor where its lateral sigma is above this
  double usual_surprise = 0.6;  ///< mean square of innovations over their variances where noise is as assumed
  double height_error = 0.002;  ///< of a camera's height, relative: it scales all that lies aside
  double bend_doubt = 4000;     ///< [m] times the road's usual step: share by which variances are larger than
                                ///< the state's, as roads bend otherwise between knots
  double sigma_scale = 0.76;    ///< on the sigmas that are told
  double protection = 4;        ///< sigmas of the protection level
};

}  // namespace lanefuse
