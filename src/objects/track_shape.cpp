// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/track_shape.hpp"

#include <algorithm>
#include <cmath>

#include "core/pose2.hpp"

namespace lanefuse {
namespace {

constexpr double kTruckWidth = 2.2;  ///< [m] wider is a truck or a bus

Eigen::Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
Eigen::Vector2d left_of(const Eigen::Vector2d& ahead) { return {-ahead.y(), ahead.x()}; }

/// Reflections come from anywhere along the flank, as far as it lies in the sensor's field.
SeenPoint on_flank(const ObjectTrack& track, const SightingSet& look, const Eigen::Vector2d& from,
                   double flank_side) {
  constexpr int kParts = 8;
  const double length = track.length();
  const double axis = look.odometry_from_sensor.heading - track.heading;
  double sum = 0;
  double squares = 0;
  int count = 0;
  for (int i = 0; i < kParts; ++i) {
    const double along = (i + 0.5) / kParts * length;
    const Eigen::Vector2d sight(along - from.x(), flank_side - from.y());
    const double bearing = wrap_angle(std::atan2(sight.y(), sight.x()) - axis);
    if (!look.field.contains(sight.norm(), bearing)) continue;
    sum += along;
    squares += along * along;
    ++count;
  }
  constexpr double kUneven = 0.15;  // of the length: wheels and corners shine
  SeenPoint point{length / 2, flank_side, 0.3 * length, 0, true};
  if (count > 0) {
    point.along = sum / count;
    point.along_sigma = std::sqrt(std::max(0.0, squares / count - point.along * point.along));
  }
  point.along_sigma = std::hypot(point.along_sigma, kUneven * length);
  return point;
}

/// By the width whether it is a truck, once that is sure; a length that has been seen is not given up.
void judge_kind(ObjectTrack& track) {
  constexpr double kBetween = 7.5;  // [m] longer than cars, shorter than trucks
  const bool is_wide = track.width - track.width_sigma > kTruckWidth;
  const bool is_narrow = track.width + track.width_sigma < kTruckWidth;
  if (is_wide && track.length() < kBetween) suppose_length(track, kTruckLength, kTruckLengthSigma);
  if (is_narrow && track.length() > kBetween) suppose_length(track, kCarLength, kCarLengthSigma);
}

}  // namespace

SeenPoint seen_point(const ObjectTrack& track, const SightingSet& look, const Eigen::Vector2d& place,
                     const ObjectTrackerConfig& config) {
  const Eigen::Vector2d ahead = direction(track.heading);
  const auto in_vehicle = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d from_rear = point - track.position();
    return Eigen::Vector2d(from_rear.dot(ahead), from_rear.dot(left_of(ahead)));
  };
  const Eigen::Vector2d from = in_vehicle(look.odometry_from_sensor.position());
  const double half = track.width / 2;
  const double length = track.length();
  const SeenPoint end{from.x() > length / 2 ? length : 0, 0, config.depth, config.scatter};
  // From straight ahead or behind, and from afar, no flank is seen.
  constexpr double kSlant = 0.12;
  const double off_side = std::abs(from.y()) - half;
  const double before_end = std::max({0.0, -from.x(), from.x() - length});
  if (off_side < kSlant * before_end || off_side < 0) return end;
  const Eigen::Vector2d at = in_vehicle(place);
  const double flank_side = std::copysign(half, from.y());
  const double off_end = std::abs(at.x() - end.along);
  const double off_flank = std::hypot(at.y() - flank_side, std::max({0.0, -at.x(), at.x() - length}));
  // The corner belongs to the end, whose place along is worth more.
  const bool beside = from.x() > 0 && from.x() < length;
  if (!beside && off_flank + config.depth >= off_end) return end;
  SeenPoint flank = on_flank(track, look, from, flank_side);
  flank.across_sigma = std::hypot(config.flank_sigma, track.width_sigma / 2);
  return flank;
}

Silhouette silhouette(const ObjectTrack& track, const SightingSet& look, double length, double width) {
  const Eigen::Vector2d ahead = direction(track.heading);
  const Pose2 sensor_from_odometry = look.odometry_from_sensor.inverse();
  const auto bearing = [&](double along, double across) {
    const Eigen::Vector2d at =
        sensor_from_odometry * Eigen::Vector2d(track.position() + along * ahead + across * left_of(ahead));
    return std::atan2(at.y(), at.x());
  };
  const double rear = bearing(0, 0);
  double low = 0;
  double high = 0;
  for (const double along : {0.0, length}) {
    for (const double across : {-width / 2, width / 2}) {
      const double angle = wrap_angle(bearing(along, across) - rear);
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
  }
  return {(low + high) / 2, high - low};
}

void update_width(ObjectTrack& track, const SightingSet& look, const Sighting& sighting) {
  if (!sighting.angular_width) return;
  constexpr double kRelative = 0.05;  // of a width: bodies are no boxes
  constexpr double kNarrowest = 1.5;  // [m]
  constexpr double kWidest = 2.6;     // [m]
  constexpr double kStep = 0.1;       // [m]
  const double length = track.length();
  const double expected = silhouette(track, look, length, track.width).width;
  const double by_width = (silhouette(track, look, length, track.width + kStep).width - expected) / kStep;
  const double by_length = (silhouette(track, look, length + kStep, track.width).width - expected) / kStep;
  if (by_width <= 0) return;
  const Eigen::Vector2d apart = track.position() - look.odometry_from_sensor.position();
  const Eigen::Vector2d sight = apart.normalized();
  const double range_sigma =
      std::sqrt(std::max(0.0, sight.dot(track.state.covariance.block<2, 2>(kTrackX, kTrackX) * sight)));
  const double by_range = expected / std::max(1.0, apart.norm());
  const double length_sigma = std::sqrt(track.state.covariance(kTrackLength, kTrackLength));
  const double sigma = std::hypot(std::hypot(sighting.angular_width_sigma, by_range * range_sigma),
                                  std::hypot(by_length * length_sigma, kRelative * expected)) /
                       by_width;
  const double surprise = (*sighting.angular_width - expected) / by_width;
  const double variance = track.width_sigma * track.width_sigma;
  const double gain = variance / (variance + sigma * sigma);
  track.width = std::clamp(track.width + gain * surprise, kNarrowest, kWidest);
  track.width_sigma = std::max(0.06, track.width_sigma * std::sqrt(1 - gain));
  judge_kind(track);
}

void suppose_length(ObjectTrack& track, double length, double sigma) {
  auto& [mean, covariance] = track.state;
  const double before = covariance(kTrackLength, kTrackLength);
  if (before <= 0) return;
  const Eigen::Matrix<double, kTrackStateSize, 1> slope = covariance.col(kTrackLength) / before;
  mean += slope * (length - mean[kTrackLength]);
  covariance += slope * slope.transpose() * (sigma * sigma - before);
}

}  // namespace lanefuse
