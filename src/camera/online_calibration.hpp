// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "camera/lane_tracker.hpp"
#include "core/kalman.hpp"
#include "core/time.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

struct OnlineCalibrationConfig {
  /// How well the rig's mounting is known [m, rad].
  double height_sigma = 0.03;
  double roll_sigma = 0.005;
  double pitch_sigma = 0.010;
  double yaw_sigma = 0.007;
  /// The lanes' true width [m] between the inner edges of their markings, where it is known: the only thing
  /// in the image that tells the height.
  std::optional<double> lane_width;
  double lane_width_sigma = 0.05;  ///< [m]
};

/// How a camera stands over the road, learned while driving: the mean pitch from the tracked pitch, the yaw
/// from the way the car drives relative to what it sees, the roll from how wide neighbouring lanes look, the
/// height from a known lane width only.
///
/// A camera that is knocked out of place is noticed and learned anew. Deterministic; allocates nothing.
class OnlineCalibration {
 public:
  explicit OnlineCalibration(const Mounting& mounting, const OnlineCalibrationConfig& config = {});

  /// What to hand to the tracker: the mounting as corrected, with the covariance of the correction. The pitch
  /// and vertical curvature of single images are not in it.
  [[nodiscard]] const CameraPose& pose() const { return pose_; }
  [[nodiscard]] CalibrationStatus status() const { return status_; }

  /// Learns from a track that was made with pose().
  void update(const LaneTrack& track, double speed, double yaw_rate, Time time);
  void reset();

 private:
  OnlineCalibrationConfig config_;
  Mounting mounting_;
  CameraPose pose_;
  CalibrationStatus status_ = CalibrationStatus::learning;
};

}  // namespace lanefuse
