// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/pose2.hpp"
#include "roadmap/commonroad.hpp"
#include "simulation/smooth_curve.hpp"

namespace lanefuse {

/// The motion of one point of a recorded vehicle, smooth and free of contradictions: heading, speed and yaw
/// rate are the derivatives of the position, so that the point never slips and never moves backwards.
///
/// The recorded places are noisy and come at some 10 Hz. A smooth path is laid through them, along which the
/// vehicle moves at a smooth speed; in a jam the path stands still with it.
class RecordedMotion {
 public:
  struct State {
    Pose2 pose;           ///< heading where it moves to
    double way = 0;       ///< [m] along the path since the beginning
    double speed = 0;     ///< [m/s]
    double yaw_rate = 0;  ///< [rad/s]
  };

  /// Of the point that lies `ahead` [m] of the middle of the vehicle's box.
  RecordedMotion(const RecordedVehicle& vehicle, double ahead);

  [[nodiscard]] double begin() const { return begin_; }  ///< [s] of the first recorded state
  [[nodiscard]] double end() const { return end_; }      ///< [s] of the last one
  [[nodiscard]] bool is_there(double time) const { return time >= begin_ && time <= end_; }
  [[nodiscard]] State at(double time) const;

 private:
  /// Across the plane, by the way.
  struct Path {
    SmoothCurve x;
    SmoothCurve y;
    [[nodiscard]] Pose2 pose(double way) const;
  };

  double begin_;
  double end_;
  std::vector<double> ways_;  ///< [m] of every recorded state, as it was recorded
  SmoothCurve way_;           ///< by the time
  Path path_;

  static Path lay(const std::vector<RecordedState>& states, const std::vector<double>& ways);
  static Path beside(const Path& middle, const std::vector<double>& ways, double ahead);
};

}  // namespace lanefuse
