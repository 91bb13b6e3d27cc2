// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/pose2.hpp"
#include "core/time.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// Where the car was at one moment, in the map's frame.
struct TrackNode {
  Time time{};
  Pose2 map_from_vehicle;
  double height = 0;  ///< [m] above the map's origin
};

/// The pose at `time`; none before the first node and after the last.
std::optional<Pose2> pose_at(std::span<const TrackNode> track, Time time);

/// Height [m] at `time`, of the nearest end outside the track. The track is not empty.
double height_at(std::span<const TrackNode> track, Time time);

/// Makes one smooth track of GNSS/INS fixes and odometry, looking both ways in time (a Kalman filter and the
/// Rauch-Tung-Striebel smoother over pose, gyro bias and speed factor). Odometry carries the track over holes
/// in the fixes; a fix that lies far off is trusted less instead of believed.
class TrackSmoother {
 public:
  struct Fix {
    Time time{};
    Pose2 map_from_vehicle;
    Eigen::Matrix3d covariance;  ///< of (x, y, heading)
    double height = 0;           ///< [m]
  };

  /// Both in order of measuring; what comes before the last one is left out.
  void add(const VehicleMotion& motion);
  void add(const Fix& fix);

  [[nodiscard]] std::size_t fix_count() const { return fixes_.size(); }
  /// The longest time from one fix to the next.
  [[nodiscard]] Duration longest_hole() const;

  /// Nodes at the fixes, and every tenth of a second between them; empty where there are fewer than two fixes
  /// while the odometry speaks.
  [[nodiscard]] std::vector<TrackNode> smooth() const;

 private:
  struct Reckoned {
    Time time;
    Pose2 odometry_from_vehicle;
  };
  struct Instant {
    Time time;
    const Fix* fix;  ///< null between fixes
  };

  std::vector<Reckoned> reckoned_;
  double speed_ = 0;
  double yaw_rate_ = 0;
  std::vector<Fix> fixes_;

  [[nodiscard]] std::vector<Instant> instants() const;
  [[nodiscard]] Pose2 odometry_at(Time time) const;
};

}  // namespace lanefuse
