// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/lane_change_watch.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

using Course = Gaussian<3>;  ///< heading [rad], curvature [1/m], its change [1/m^2]
using Row = Eigen::Matrix<double, 1, 3>;

constexpr double kHeadingSigma = 0.02;    ///< [rad] of our own heading against the road
constexpr double kCurvatureSigma = 5e-4;  ///< [1/m] of the road against our own way
constexpr double kChangeSigma = 1e-5;     ///< [1/m^2]
constexpr double kDriverSigma = 0.006;    ///< [rad] of drivers about the road's direction
constexpr double kReach = 160;            ///< [m]

Row row_at(double x) { return {1, x, x * x / 2}; }

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

/// Twice: the second time without those that stood out.
Gaussian<3> LaneChangeWatch::course(double own_curvature) const {
  Course prior;
  prior.mean << 0, own_curvature, 0;
  prior.covariance = Eigen::Vector3d(kHeadingSigma, kCurvatureSigma, kChangeSigma).cwiseAbs2().asDiagonal();
  Course course = prior;
  for (int round = 0; round < 2; ++round) {
    Course fitted = prior;
    for (const Witness& seen : witnesses_) {
      const Row row = row_at(seen.x);
      const double variance = seen.sigma * seen.sigma + kDriverSigma * kDriverSigma;
      const double surprise = seen.heading - row.dot(course.mean);
      const double expected = variance + (row * course.covariance * row.transpose()).value();
      constexpr double kStandsOut = 4;  // squared sigmas
      const double doubt = std::max(1.0, surprise * surprise / (kStandsOut * expected));
      update<3, 1>(fitted, Eigen::Matrix<double, 1, 1>(seen.heading - row.dot(fitted.mean)), row,
                   Eigen::Matrix<double, 1, 1>(variance * doubt * doubt));
    }
    course = fitted;
  }
  return course;
}

void LaneChangeWatch::look(const SightingSet& look, double seconds, const ObjectTrackerConfig& config,
                           std::span<ObjectTrack> tracks) {
  const Pose2 vehicle_from_odometry = look.odometry_from_vehicle.inverse();
  witnesses_.clear();
  for (const ObjectTrack& track : tracks) {
    if (const auto seen = witness(track, vehicle_from_odometry, config.min_speed))
      witnesses_.push_back(*seen);
  }
  const Course course = this->course(look.own_curvature);
  for (ObjectTrack& track : tracks) {
    const auto seen = witness(track, vehicle_from_odometry, config.min_speed);
    if (!seen) continue;
    const Row row = row_at(seen->x);
    const double speed = track.speed();
    const double across = std::abs(seen->heading - row.dot(course.mean)) * speed;
    const double sigma =
        speed * std::sqrt(seen->sigma * seen->sigma + (row * course.covariance * row.transpose()).value());
    const bool moves = across > config.change_speed && across > 2 * sigma;
    track.across_s = std::clamp(track.across_s + (moves ? seconds : -seconds), 0.0, 2 * config.change_s);
    if (track.across_s > config.change_s) track.changing_lane = true;
    if (track.across_s <= 0) track.changing_lane = false;
  }
}

}  // namespace lanefuse
