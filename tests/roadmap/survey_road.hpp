// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "roadmap/geo_frame.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

/// A road around a circle, and drives on it whose sensors do not err: what a survey must get exactly right.
namespace lanefuse::testing {

inline constexpr GeoOrigin kOrigin{48.2, 11.6, 500};
inline constexpr double kRadius = 2000;     ///< [m] of the road's middle
inline constexpr double kSpeed = 30;        ///< [m/s]
inline constexpr double kLaneWidth = 3.6;   ///< [m]
inline constexpr double kEdgePaint = 0.30;  ///< [m]
inline constexpr double kLanePaint = 0.15;  ///< [m]

inline Rig survey_rig() {
  return {{{1, SensorKind::odometry, "odometry", {}},
           {2, SensorKind::serial_camera, "serial camera", {}},
           {5, SensorKind::gnss_ins, "GNSS/INS", {0.4, 0.1, 1.3, 0, 0, 0.02}}}};
}

/// The place at `station` [m] along the road and `lateral` [m] to its left, for a road laid at `world`.
inline Pose2 on_road(const Pose2& world, double station, double lateral) {
  const double angle = station / kRadius;
  return world *
         Pose2{(kRadius - lateral) * std::sin(angle), kRadius - (kRadius - lateral) * std::cos(angle), angle};
}

/// One drive on lane 0 or 1 of two; boundaries lie at +width, 0 and -width.
struct SurveyDriver {
  Pose2 world;
  int lane = 0;
  double seconds = 20;
  double camera_yaw = 0;  ///< [rad]
  Duration latency{60'000'000};

  [[nodiscard]] double lateral() const { return (lane == 0 ? 0.5 : -0.5) * kLaneWidth; }

  [[nodiscard]] std::vector<Measurement> drive() const {
    std::vector<Measurement> measurements;
    for (int tick = 0; tick <= static_cast<int>(seconds * 50); ++tick) {
      const double station = kSpeed * tick / 50.0;
      const Time time = from_nanoseconds(1'000'000'000 + tick * 20'000'000LL);
      measurements.emplace_back(VehicleMotion{{time, time, 1}, speed(), speed() / radius(), {}});
      measurements.emplace_back(fix(time, station));
      if (tick % 2 == 0) measurements.emplace_back(sight(time));
    }
    return measurements;
  }

 private:
  [[nodiscard]] double radius() const { return kRadius - lateral(); }
  [[nodiscard]] double speed() const { return kSpeed * radius() / kRadius; }

  [[nodiscard]] GnssInsFix fix(Time time, double station) const {
    const GeoFrame frame(kOrigin);
    const Mounting mounting = survey_rig().sensors[2].mounting;
    const Pose2 pose = on_road(world, station, lateral()) * Pose2{mounting.x, mounting.y, mounting.yaw};
    const GeoOrigin there = frame.place({pose.x, pose.y, mounting.z});
    constexpr double kDegree = std::numbers::pi / 180;
    return {.stamp = {time, time, 5},
            .latitude = there.latitude_deg * kDegree,
            .longitude = there.longitude_deg * kDegree,
            .height = there.height,
            .heading = wrap_angle(pose.heading - frame.convergence(there)),
            .position_covariance = 4e-4 * Eigen::Matrix3d::Identity(),
            .heading_sigma = 1e-3,
            .kind = FixKind::rtk_fixed};
  }

  [[nodiscard]] ClothoidMeasurement edge(Side side) const {
    const bool is_edge = (lane == 0) == (side == Side::left);
    const double to_edge = kLaneWidth / 2 - (is_edge ? kEdgePaint : kLanePaint) / 2;
    const double offset = side == Side::left ? to_edge : -to_edge;
    const double curvature = 1 / (radius() - offset);
    ClothoidMeasurement measurement;
    measurement.clothoid = {offset, camera_yaw, curvature, 0};
    measurement.covariance = Eigen::Vector4d(4e-4, 1e-6, 1e-10, 1e-14).asDiagonal();
    measurement.range_end = 60;
    measurement.side = side;
    measurement.marking = {is_edge ? MarkingType::solid : MarkingType::dashed, MarkingColour::white};
    return measurement;
  }

  [[nodiscard]] SerialLane sight(Time time) const {
    SerialLane lane_seen;
    lane_seen.stamp = {time, time + latency, 2};
    lane_seen.left = edge(Side::left);
    lane_seen.right = edge(Side::right);
    return lane_seen;
  }
};

}  // namespace lanefuse::testing
