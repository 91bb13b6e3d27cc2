// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/high_resolution_camera_model.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kNearest = 5;    ///< [m] ahead of the origin; the bonnet hides what is nearer
constexpr double kSpacing = 2.5;  ///< [m] between the bars that the detector looks for along a line
constexpr double kBarLength = 1;  ///< [m] of paint that shows its direction
constexpr double kField = 0.63;   ///< [rad] to either side: 3840 columns of .327 mrad

}  // namespace

HighResolutionCameraModel::HighResolutionCameraModel(const SensorPreset& preset, std::uint64_t seed)
    : preset_(preset.high_resolution_camera),
      noise_(preset.noise),
      pose_(preset.camera_pose),
      random_(seed, "high-resolution camera"),
      view_(preset.camera_pose, random_),
      shared_(preset_.shared_sigma_at_100_m, preset_.shared_tau, random_) {}

SensorDescription HighResolutionCameraModel::description() const {
  return {3, SensorKind::high_resolution_camera, "high-resolution camera", {0, 0, pose_.height, 0, 0, 0}};
}

double HighResolutionCameraModel::reach(const Scene& scene) const {
  return std::min(preset_.range_max, scene.visibility);
}

double HighResolutionCameraModel::detection(double x) const {
  return preset_.detection_near + (preset_.detection_at_130_m - preset_.detection_near) * x / 130;
}

/// All that may be wrong with one feature by itself, as its maker would state it: along the ray the row and
/// the pitch, across it the column, the paint, the yaw and the error shared by the frame. Yaw, pitch (a line
/// beside the car fans out or in) and the shared error turn it, too.
Eigen::Matrix3d HighResolutionCameraModel::covariance(const Feature& feature) const {
  const double range = std::hypot(feature.x, feature.y);
  const double noise = preset_.noise_px * preset_.pixel;
  const double along = range * range / pose_.height * std::hypot(noise, pose_.residual_pitch);
  const double shared = preset_.shared_sigma_at_100_m * feature.x / 100;
  const double across =
      std::hypot(range * std::hypot(noise, pose_.yaw_bias), std::hypot(preset_.noise, shared));
  const double fanned = feature.y / pose_.height * pose_.residual_pitch;
  const double turned = std::hypot(pose_.yaw_bias, preset_.shared_sigma_at_100_m / 100, fanned);
  const Eigen::Vector3d sigma(along, across, std::hypot(preset_.heading.at(range), turned));
  return rotate_covariance((sigma / noise_).array().square().matrix().asDiagonal(),
                           std::atan2(feature.y, feature.x));
}

/// Something else that the detector takes for paint.
HighResolutionCameraModel::Bar HighResolutionCameraModel::replace_by_outlier(const Scene& scene,
                                                                             double station) {
  const double left = scene.road->guard_rail(+1, station);
  const double right = scene.road->guard_rail(-1, station);
  if (random_.chance(preset_.outliers_on_guard_rail)) return {station, random_.chance(0.5) ? left : right};
  return {station, random_.uniform(right, left)};
}

/// Where the camera believes a point of the vehicle frame to be, with all that is wrong in this frame.
std::optional<Eigen::Vector2d> HighResolutionCameraModel::see(const Eigen::Vector2d& point, double height,
                                                              const GroundView::PixelError& error) const {
  auto seen = view_.see(point, height, error);
  if (seen) seen->y() += shared_.value() * point.x() / 100;
  return seen;
}

void HighResolutionCameraModel::observe_bar(const Scene& scene, const LineOfSight& sight, const Bar& place,
                                            std::vector<Feature>& features) {
  Pose2 bar = scene.ego.world_from_vehicle.inverse() * scene.road->pose(place.station, place.lateral);
  bar.heading += place.turn;
  if (bar.x < kNearest || bar.x > reach(scene) || std::abs(std::atan2(bar.y, bar.x)) > kField) return;
  if (!random_.chance(detection(bar.x)) || sight.blocked(bar.position())) return;
  const double noise = preset_.noise_px * preset_.pixel;
  const GroundView::PixelError error{random_.normal(noise), random_.normal(noise)};
  const RoadHeight& road = scene.road->height();
  const auto seen = see(bar.position(), road.above_tangent(scene.ego.station, place.station), error);
  const auto ahead = see(bar * Eigen::Vector2d(kBarLength, 0),
                         road.above_tangent(scene.ego.station, place.station + kBarLength), error);
  if (!seen || !ahead) return;
  const Eigen::Vector2d along = *ahead - *seen;
  Feature feature;
  feature.x = seen->x();
  feature.y = seen->y() + random_.normal(preset_.noise);
  feature.heading = std::atan2(along.y(), along.x()) + random_.normal(preset_.heading.at(bar.x));
  feature.confidence = detection(std::min(feature.x, preset_.range_max)) * (1 - preset_.outliers);
  feature.covariance = covariance(feature);
  feature.source = Source::high_resolution_camera;
  feature.marking.colour = place.colour;
  feature.label = place.label;
  features.push_back(feature);
}

HighResolutionCameraModel::Bar HighResolutionCameraModel::bar_of(const Road& road, int line, double station) {
  const double lateral = road.line_lateral(line, station);
  const double along = 1 - road.reference().curvature(station) * lateral;
  const double turn = std::atan2(road.line_slope(line, station), along);
  return {station, lateral, turn, road.marking(line, station).colour, road.line_label(line)};
}

void HighResolutionCameraModel::observe_line(const Scene& scene, const LineOfSight& sight, int line,
                                             std::vector<Feature>& features) {
  const double first = scene.ego.station + kNearest;
  const double last = scene.ego.station + preset_.range_max + kSpacing;
  if (!scene.road->line_runs_within(line, {first - kSpacing, last})) return;
  for (double station = first + random_.uniform(-kSpacing, 0); station < last; station += kSpacing) {
    if (!scene.road->painted(line, station)) continue;
    const bool outlier = random_.chance(preset_.outliers);
    const Bar bar = outlier ? replace_by_outlier(scene, station) : bar_of(*scene.road, line, station);
    observe_bar(scene, sight, bar, features);
  }
}

void HighResolutionCameraModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  view_.advance(1 / preset_.hz, random_);
  shared_.advance(1 / preset_.hz, random_);
  const LineOfSight sight(scene);
  MarkingFeatures frame;
  frame.stamp = stamp(description(), scene.time, preset_.latency);
  frame.shared_error =
      SharedError{SharedError::Kind::lateral_growing_with_range, preset_.shared_sigma_at_100_m / noise_};
  for (int i = 0; i < scene.road->line_count(); ++i) observe_line(scene, sight, i, frame.features);
  measurements.emplace_back(std::move(frame));
}

}  // namespace lanefuse
