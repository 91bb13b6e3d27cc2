// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/high_resolution_camera_model.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::Moments;
using testing::SceneRun;

constexpr double kDegree = std::numbers::pi / 180;

/// Across the nearest marking: the error and the sigma that the feature states for it.
struct Across {
  int boundary;
  double error;
  double sigma;
};

Across across(const Scene& scene, const Feature& feature) {
  const Eigen::Vector2d place = testing::place_of(scene, {feature.x, feature.y});
  const int boundary = testing::nearest_line(*scene.road, place);
  const double along = scene.road->pose(place.x(), place.y()).heading - scene.ego.world_from_vehicle.heading;
  const Eigen::Vector2d normal(-std::sin(along), std::cos(along));
  const double variance = normal.dot(feature.covariance.topLeftCorner<2, 2>() * normal);
  return {boundary, place.y() - scene.road->line_lateral(boundary, place.x()), std::sqrt(variance)};
}

/// The nominal camera without outliers.
SensorPreset without_outliers() {
  SensorPreset preset = nominal_preset();
  preset.high_resolution_camera.outliers = 0;
  return preset;
}

/// Without the pitch, which moves features along the ray: a sideways error only off the axis, and hard to sum
/// up.
SensorPreset without_pitch(SensorPreset preset) {
  preset.camera_pose.residual_pitch = 0;
  return preset;
}

/// Shows every frame of some drives.
template <typename Seen>
void watch_frames(const SensorPreset& preset, Seen seen) {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SceneRun run(seed);
    HighResolutionCameraModel model(preset, seed);
    run.watch(model, 30, [&](const Scene& scene, const Measurement& measurement) {
      seen(scene, std::get<MarkingFeatures>(measurement).features);
    });
  }
}

/// Shows every feature of some drives.
template <typename Seen>
void watch_features(const SensorPreset& preset, Seen seen) {
  watch_frames(preset, [&](const Scene& scene, const std::vector<Feature>& features) {
    for (const Feature& feature : features) seen(scene, feature);
  });
}

TEST(HighResolutionCameraModel, ErrsAcrossTheLineAsThePresetSays) {
  std::map<int, Moments> errors;  // of the ego lane's own markings, by 20 m
  std::map<int, Moments> expected;
  watch_features(without_pitch(without_outliers()), [&](const Scene& scene, const Feature& feature) {
    if (feature.x > 120) return;
    const Across found = across(scene, feature);
    const int lane = *scene.road->lane_at(scene.ego.station, scene.ego.lateral);
    if (found.boundary != lane && found.boundary != lane + 1) return;
    const int bin = static_cast<int>(feature.x / 20);
    const double turned = std::hypot(0.12 * kDegree, 1.4 * 0.327e-3) * feature.x;
    const double shared = 0.15 * feature.x / 100;
    errors[bin].add(found.error);
    expected[bin].add(std::hypot(turned, std::hypot(shared, 0.03)));
  });
  ASSERT_EQ(errors.size(), 6u);
  for (const auto& [bin, error] : errors) {
    EXPECT_GT(error.count(), 2000);
    EXPECT_NEAR(error.rms() / expected[bin].rms(), 1, 0.25) << "from " << bin * 20 << " m: " << error.rms();
  }
}

TEST(HighResolutionCameraModel, StatesAnHonestCovariance) {
  std::map<int, Moments> normalised;
  Moments heading;
  watch_features(without_outliers(), [&](const Scene& scene, const Feature& feature) {
    const Across found = across(scene, feature);
    normalised[static_cast<int>(feature.x / 40)].add(found.error / found.sigma);
    const Eigen::Vector2d place = testing::place_of(scene, {feature.x, feature.y});
    const double truth = scene.road->pose(place.x(), 0).heading - scene.ego.world_from_vehicle.heading;
    if (feature.x < 60) heading.add((feature.heading - truth) / std::sqrt(feature.covariance(2, 2)));
  });
  for (const int bin : {0, 1, 2}) {
    EXPECT_NEAR(normalised[bin].rms(), 1, 0.3) << "from " << bin * 40 << " m";
    EXPECT_NEAR(normalised[bin].mean(), 0, 0.35);
  }
  EXPECT_NEAR(heading.rms(), 1, 0.1);
}

TEST(HighResolutionCameraModel, DetectsLessFarAway) {
  std::map<int, double> seen, painted;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SceneRun run(seed);
    SensorPreset preset = run.preset();
    preset.high_resolution_camera.outliers = 0;
    preset.traffic.vehicles_per_metre_lane = 0;
    Traffic empty(run.road(), nominal_traffic(preset), 400, seed);
    HighResolutionCameraModel model(preset, seed);
    for (int frame = 0; frame < 200; ++frame) {
      for (int tick = 0; tick < 4; ++tick) empty.advance(0.02);
      const Scene scene = empty.scene(Time{});
      std::vector<Measurement> measurements;
      model.observe(scene, measurements);
      for (const Feature& feature : std::get<MarkingFeatures>(measurements.front()).features) {
        const int line = across(scene, feature).boundary;
        if (line == 0 || line == 3) seen[static_cast<int>(feature.x / 30)] += 1;
      }
      for (int bin = 0; bin < 4; ++bin) painted[bin] += 2 * 30 / 2.5;  // two edge lines, a bar every 2.5 m
    }
  }
  EXPECT_NEAR(seen[1] / painted[1], 0.95 - 0.6 * 45 / 130, 0.08);
  EXPECT_NEAR(seen[2] / painted[2], 0.95 - 0.6 * 75 / 130, 0.08);
}

TEST(HighResolutionCameraModel, TakesOtherThingsForPaintAsOftenAsThePresetSays) {
  // Near the car true features lie within half a metre of a line; what lies further away is an outlier, and
  // half of the outliers are on the rails, 3 m outside the road.
  double all = 0, elsewhere = 0, on_rail = 0;
  watch_features(without_pitch(nominal_preset()), [&](const Scene& scene, const Feature& feature) {
    if (feature.x < 15 || feature.x > 45) return;  // nearer, the camera's field leaves out the rails
    const double lateral = testing::place_of(scene, {feature.x, feature.y}).y();
    const bool rail = std::abs(std::abs(lateral) - scene.road->guard_rail(+1, scene.ego.station)) < 0.5;
    all += 1;
    on_rail += rail;
    elsewhere += !rail && std::abs(across(scene, feature).error) > 0.5;
  });
  const double random_off_lines = 1 - (4 * 1.0 + 2 * 0.5) / (2 * 8.44);  // of the room between the rails
  EXPECT_NEAR(on_rail / all, 0.05 * (0.5 + 0.5 / 17), 0.006);
  EXPECT_NEAR(elsewhere / all, 0.05 * 0.5 * random_off_lines, 0.006);
}

TEST(HighResolutionCameraModel, NeverSeesThroughVehicles) {
  double free = 0, hidden = 0;
  watch_features(without_outliers(), [&](const Scene& scene, const Feature& feature) {
    if (feature.x > 60) return;
    const LineOfSight sight(scene);
    (sight.blocked({feature.x, feature.y}) ? hidden : free) += 1;
  });
  EXPECT_GT(free, 10'000);
  EXPECT_LT(hidden / free, 0.02);  // only noise puts a feature behind a vehicle
}

/// How the errors of the ego car's left and right marking go together within a frame, in [-1, 1].
double correlation_within_frames(const SensorPreset& preset) {
  double product = 0, squares = 0;
  watch_frames(preset, [&](const Scene& scene, const std::vector<Feature>& features) {
    Moments left, right;
    const int lane = *scene.road->lane_at(scene.ego.station, scene.ego.lateral);
    for (const Feature& feature : features) {
      if (feature.x < 40 || feature.x > 80) continue;
      const Across found = across(scene, feature);
      if (found.boundary == lane) left.add(found.error);
      if (found.boundary == lane + 1) right.add(found.error);
    }
    if (left.count() < 1 || right.count() < 1) return;
    product += left.mean() * right.mean();
    squares += (left.mean() * left.mean() + right.mean() * right.mean()) / 2;
  });
  return product / squares;
}

TEST(HighResolutionCameraModel, LeansAsAFrame) {
  EXPECT_GT(correlation_within_frames(without_pitch(without_outliers())), 0.5);
}

TEST(HighResolutionCameraModel, PitchSpreadsTheLaneAsAFrame) {
  SensorPreset only_pitch = without_outliers();
  only_pitch.camera_pose.yaw_bias = 0;
  only_pitch.high_resolution_camera.shared_sigma_at_100_m = 0;
  EXPECT_LT(correlation_within_frames(only_pitch), -0.4);
}

TEST(HighResolutionCameraModel, DirectionsLeanWithThePlaces) {
  // Averaged over a frame only what the frame shares is left: the headings' error is the slope of the
  // places'.
  SensorPreset preset = without_pitch(without_outliers());
  double product = 0, places = 0, headings = 0;
  watch_frames(preset, [&](const Scene& scene, const std::vector<Feature>& features) {
    Moments slope, heading;
    for (const Feature& feature : features) {
      if (feature.x < 50 || feature.x > 90) continue;
      const Eigen::Vector2d place = testing::place_of(scene, {feature.x, feature.y});
      const double truth = scene.road->pose(place.x(), 0).heading - scene.ego.world_from_vehicle.heading;
      slope.add(across(scene, feature).error / feature.x);
      heading.add(feature.heading - truth);
    }
    if (slope.count() < 20) return;
    product += slope.mean() * heading.mean();
    places += slope.mean() * slope.mean();
    headings += heading.mean() * heading.mean();
  });
  EXPECT_GT(product / places, 0.6);
  EXPECT_GT(product / std::sqrt(places * headings), 0.4);
}

}  // namespace
}  // namespace lanefuse
