// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/lane_change_watch.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

using Row = Eigen::Matrix<double, 1, 3>;

constexpr double kHeadingSigma = 0.02;    ///< [rad] of our own heading against the road
constexpr double kCurvatureSigma = 2e-4;  ///< [1/m] of the road against our own way
constexpr double kChangeSigma = 2e-6;     ///< [1/m^2]
constexpr double kDriverSigma = 0.006;    ///< [rad] of drivers about the road's direction
constexpr double kReach = 160;            ///< [m]

}  // namespace

std::optional<LaneChangeWatch::Witness> LaneChangeWatch::witness(const ObjectTrack& track,
                                                                 const Pose2& vehicle_from_odometry,
                                                                 double min_speed) {
  const double speed = track.speed();
  const Eigen::Vector2d at = vehicle_from_odometry * track.position();
  const double heading = wrap_angle(track.heading + vehicle_from_odometry.heading);
  constexpr double kSameWay = 0.5;  // [rad]
  if (!track.confirmed || track.refused || speed < min_speed || std::abs(at.x()) > kReach ||
      std::abs(heading) > kSameWay) {
    return {};
  }
  const Eigen::Vector2d across(-std::sin(track.heading), std::cos(track.heading));
  const double variance = across.dot(track.state.covariance.block<2, 2>(kTrackVx, kTrackVx) * across);
  return Witness{at.x(), heading, std::sqrt(std::max(0.0, variance)) / speed};
}

/// Those that stand out from what is known count less.
RoadCourse LaneChangeWatch::fitted(const RoadCourse& prior, const RoadCourse& known) const {
  constexpr double kStandsOut = 4;  // squared sigmas
  RoadCourse course = prior;
  for (const Witness& seen : witnesses_) {
    const RoadCourse::Estimate expected = known.heading(seen.x);
    const double variance = seen.sigma * seen.sigma + kDriverSigma * kDriverSigma;
    const double surprise = seen.heading - expected.value;
    const double doubt =
        std::max(1.0, surprise * surprise / (kStandsOut * (variance + expected.sigma * expected.sigma)));
    const Row row(1, seen.x, seen.x * seen.x / 2);
    update<3, 1>(course.line, Eigen::Matrix<double, 1, 1>(seen.heading - course.heading(seen.x).value), row,
                 Eigen::Matrix<double, 1, 1>(variance * doubt * doubt));
  }
  return course;
}

RoadCourse LaneChangeWatch::course(const SightingSet& look, const ObjectTrackerConfig& config,
                                   std::span<const ObjectTrack> tracks) {
  const Pose2 vehicle_from_odometry = look.odometry_from_vehicle.inverse();
  witnesses_.clear();
  for (const ObjectTrack& track : tracks) {
    if (const auto seen = witness(track, vehicle_from_odometry, config.min_speed))
      witnesses_.push_back(*seen);
  }
  RoadCourse prior;
  prior.line.mean << 0, look.own_curvature, 0;
  prior.line.covariance =
      Eigen::Vector3d(kHeadingSigma, kCurvatureSigma, kChangeSigma).cwiseAbs2().asDiagonal();
  return fitted(prior, fitted(prior, prior));
}

void LaneChangeWatch::mark(const SightingSet& look, double seconds, const RoadCourse& course,
                           const ObjectTrackerConfig& config, std::span<ObjectTrack> tracks) const {
  const Pose2 vehicle_from_odometry = look.odometry_from_vehicle.inverse();
  for (ObjectTrack& track : tracks) {
    const auto seen = witness(track, vehicle_from_odometry, config.min_speed);
    if (!seen) continue;
    const RoadCourse::Estimate road = course.heading(seen->x);
    const double across = std::abs(seen->heading - road.value) * track.speed();
    const double sigma = std::hypot(seen->sigma, road.sigma) * track.speed();
    const bool moves = across > config.change_speed && across > 1.6 * sigma;
    track.across_s = std::clamp(track.across_s + (moves ? seconds : -seconds), 0.0, 2 * config.change_s);
    if (track.across_s > config.change_s) track.changing_lane = true;
    if (track.across_s <= 0) track.changing_lane = false;
  }
}

}  // namespace lanefuse
