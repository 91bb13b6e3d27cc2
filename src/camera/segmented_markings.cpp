// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/segmented_markings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace lanefuse {
namespace {

constexpr double kReach = 3;         ///< [m] ahead and behind over which a line's heading is taken
constexpr double kShortest = 1;      ///< [m] of line that has a heading
constexpr double kSideways = 0.25;   ///< [m] by which neighbours of one line differ, beside the slope below
constexpr double kSteepest = 0.35;   ///< of a line across the road, a metre of it
constexpr double kNarrowest = 0.02;  ///< [m] of paint
constexpr double kRaggedHeading = 0.01;  ///< [rad] of the paint itself

/// A run of paint on the road.
struct Place {
  std::size_t run;
  Eigen::Vector2d ground;
};

std::vector<Place> places_of(const std::vector<ImageBar>& runs, const GroundProjection& projection,
                             const LaneSegmentationConfig& config) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const ImageBar& run = runs[i];
    const auto left = projection.ground({run.left, run.row});
    const auto right = projection.ground({run.right, run.row});
    const auto middle = projection.ground({(run.left + run.right) / 2, run.row});
    if (!left || !right || !middle || middle->x() > config.range_max) continue;
    const double width = left->y() - right->y();
    if (width > kNarrowest && width < config.width_max) places.push_back({i, *middle});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.ground.x() < b.ground.x(); });
  return places;
}

/// The line through a place's neighbours.
struct Direction {
  double heading = 0;
  double length = 0;  ///< [m] of line it was taken from
  int count = 0;
};

std::optional<Direction> direction_at(const std::vector<Place>& places, std::size_t index) {
  const Eigen::Vector2d& here = places[index].ground;
  const auto first = std::lower_bound(places.begin(), places.end(), here.x() - kReach,
                                      [](const Place& p, double x) { return p.ground.x() < x; });
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, low = 0, high = 0;
  for (auto place = first; place != places.end() && place->ground.x() <= here.x() + kReach; ++place) {
    const Eigen::Vector2d d = place->ground - here;
    if (std::abs(d.y()) > kSideways + kSteepest * std::abs(d.x())) continue;
    n += 1;
    sx += d.x();
    sy += d.y();
    sxx += d.x() * d.x();
    sxy += d.x() * d.y();
    low = std::min(low, d.x());
    high = std::max(high, d.x());
  }
  const double spread = n * sxx - sx * sx;
  if (high - low < kShortest || !(spread > 0)) return {};
  return Direction{std::atan((n * sxy - sx * sy) / spread), high - low, static_cast<int>(n)};
}

/// Pixels and pose together; of the heading, what the places' own errors leave of a line of that length.
Eigen::Matrix3d covariance_at(const GroundProjection& projection, const GroundProjection::Jacobians& j,
                              const Direction& direction, double sigma_px) {
  const CameraPose& pose = projection.pose();
  const Eigen::Matrix2d pixels = j.pixel * (sigma_px * sigma_px) * j.pixel.transpose();
  const double bend = pose.vertical_curvature_sigma;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = pixels + j.pose * pose.covariance * j.pose.transpose() +
                                     bend * bend * j.vertical_curvature * j.vertical_curvature.transpose();
  const double across = pixels(1, 1);
  const double heading = 12 * across / (direction.count * direction.length * direction.length);
  covariance(2, 2) = heading + pose.covariance(3, 3) + kRaggedHeading * kRaggedHeading;
  return covariance;
}

bool is_near(const std::vector<Feature>& features, const Eigen::Vector2d& place, double spacing) {
  return std::any_of(features.begin(), features.end(), [&](const Feature& f) {
    return std::abs(f.x - place.x()) < spacing && std::abs(f.y - place.y()) < kSideways;
  });
}

}  // namespace

std::vector<Feature> features_of_runs(std::vector<ImageBar>& runs, const GroundProjection& projection,
                                      const LaneSegmentationConfig& config) {
  const std::vector<Place> places = places_of(runs, projection, config);
  std::vector<Feature> features;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector2d& ground = places[i].ground;
    if (is_near(features, ground, config.spacing)) continue;
    const ImageBar& run = runs[places[i].run];
    const auto direction = direction_at(places, i);
    const auto jacobians = projection.jacobians({(run.left + run.right) / 2, run.row});
    if (!direction || !jacobians) continue;
    Feature feature;
    feature.x = ground.x();
    feature.y = ground.y();
    feature.heading = direction->heading;
    feature.confidence = config.confidence;
    feature.covariance = covariance_at(projection, *jacobians, *direction, config.sigma_px);
    features.push_back(feature);
    runs[places[i].run].believed = true;
  }
  return features;
}

}  // namespace lanefuse
