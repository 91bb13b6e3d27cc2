// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sensor_noise.hpp"

#include <cmath>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/percentile.hpp"
#include "simulation/scene_run.hpp"
#include "simulation/simulated_drive.hpp"

namespace lanefuse {
namespace {

using testing::digest;
using testing::digest_truth;
using testing::Drive;
using testing::drive;
using testing::Moments;
using testing::short_drive;

/// Every sigma of a sensor's error, in the order of the file.
std::vector<double> sigmas_of(const SensorPreset& p) {
  const auto& [odometry, pose, high] = std::tie(p.odometry, p.camera_pose, p.high_resolution_camera);
  return {odometry.speed_scale,
          odometry.yaw_rate_white,
          odometry.yaw_rate_bias,
          pose.residual_pitch,
          pose.yaw_bias,
          p.serial_camera.noise_px,
          high.noise_px,
          high.noise,
          high.heading.base,
          high.heading.at_100_m,
          high.shared_sigma_at_100_m,
          p.object_list.sigma_y.base,
          p.object_list.sigma_y.at_100_m,
          p.object_list.heading.low,
          p.object_list.heading.high,
          p.object_list.misalignment,
          p.long_range_radar.sigma_range,
          p.long_range_radar.sigma_azimuth,
          p.long_range_radar.sigma_range_rate,
          p.long_range_radar.misalignment,
          p.short_range_radar.sigma_range,
          p.short_range_radar.sigma_azimuth,
          p.short_range_radar.sigma_range_rate,
          p.short_range_radar.misalignment,
          p.camera_boxes.sigma_edge_px,
          p.camera_boxes.sigma_base_px,
          p.gnss_ins.position,
          p.gnss_ins.heading};
}

/// What sensors do beside erring, and the world around them.
std::vector<double> others_of(const SensorPreset& p) {
  return {p.traffic.wander_sigma,
          p.traffic.driver_bias,
          p.traffic.vehicles_per_metre_lane,
          p.road.vertical_curvature_sigma,
          p.camera_pose.height,
          p.camera_pose.residual_pitch_tau,
          p.camera_pose.yaw_bias_tau,
          p.serial_camera.hz,
          p.serial_camera.latency,
          p.serial_camera.pixel,
          p.serial_camera.range_mean,
          p.serial_camera.dropout,
          p.high_resolution_camera.pixel,
          p.high_resolution_camera.detection_near,
          p.high_resolution_camera.shared_tau,
          p.high_resolution_camera.outliers,
          p.object_list.tau,
          p.object_list.range_max,
          p.long_range_radar.detection,
          p.long_range_radar.clutter,
          p.camera_boxes.false_boxes,
          p.gnss_ins.position_tau,
          p.surveyed_truth.ego};
}

Drive noisy_drive(double noise) {
  SimulationConfig config = short_drive(2);
  config.noise = noise;
  return drive(config);
}

template <typename Kind>
std::vector<Kind> all(const Drive& drive) {
  std::vector<Kind> found;
  for (const Measurement& measurement : drive.measurements) {
    if (const auto* one = std::get_if<Kind>(&measurement)) found.push_back(*one);
  }
  return found;
}

TEST(SensorNoise, ScalesEverySigmaAndNothingElse) {
  const SensorPreset nominal = nominal_preset();
  for (const double factor : {0.5, 2.0}) {
    const SensorPreset scaled = with_noise(nominal, factor);
    const std::vector<double> before = sigmas_of(nominal);
    const std::vector<double> after = sigmas_of(scaled);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_GT(before[i], 0);
      EXPECT_DOUBLE_EQ(after[i], factor * before[i]) << i;
    }
    EXPECT_EQ(others_of(scaled), others_of(nominal));
  }
}

TEST(SensorNoise, ThePresetNoLongerClaimsToBeNominal) {
  const SensorPreset nominal = nominal_preset();
  EXPECT_EQ(with_noise(nominal, 1).hash, nominal.hash);
  EXPECT_EQ(with_noise(nominal, 0.5).hash, nominal.hash + ", noise x 0.5");
  SimulationConfig config = short_drive(1);
  config.noise = 2;
  const DriveInfo info = DriveSimulation(config, nominal).info();
  EXPECT_EQ(info.preset_hash, nominal.hash + ", noise x 2");
  EXPECT_EQ(info.name, "simulated, seed 1, 0.6 km, gentle, noise x 2");
}

TEST(SensorNoise, RefusesWhatIsNoFactor) {
  for (const double factor : {0.0, -1.0, 1e6, static_cast<double>(NAN)}) {
    EXPECT_THROW(with_noise(nominal_preset(), factor), Error) << factor;
  }
}

TEST(SensorNoise, LeavesRoadAndTrafficAsTheyWere) {
  const Drive nominal = noisy_drive(1);
  EXPECT_EQ(digest(nominal), digest(drive(short_drive(2))));
  EXPECT_EQ(digest_truth(noisy_drive(2)), digest_truth(nominal));
  EXPECT_NE(digest(noisy_drive(2)), digest(nominal));
}

TEST(SensorNoise, DrawsTheSameErrorsSoManyTimesAsLarge) {
  const auto half = all<VehicleMotion>(noisy_drive(0.5));
  const auto nominal = all<VehicleMotion>(noisy_drive(1));
  const auto twice = all<VehicleMotion>(noisy_drive(2));
  ASSERT_EQ(half.size(), twice.size());
  for (std::size_t i = 0; i < half.size(); ++i) {
    EXPECT_NEAR(*twice[i].yaw_rate - *nominal[i].yaw_rate, 2 * (*nominal[i].yaw_rate - *half[i].yaw_rate),
                1e-12);
    EXPECT_NEAR(*twice[i].speed - *nominal[i].speed, 2 * (*nominal[i].speed - *half[i].speed), 1e-9);
  }
}

TEST(SensorNoise, ObjectsErrMoreThanTheyState) {
  const auto nominal = all<ObjectList>(noisy_drive(1));
  const auto half = all<ObjectList>(noisy_drive(0.5));
  const auto twice = all<ObjectList>(noisy_drive(2));
  std::size_t compared = 0;
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    ASSERT_EQ(nominal[k].objects.size(), twice[k].objects.size());
    for (std::size_t i = 0; i < nominal[k].objects.size(); ++i, ++compared) {
      const TrackedObject& one = nominal[k].objects[i];
      const TrackedObject& two = twice[k].objects[i];
      EXPECT_TRUE(two.covariance.isApprox(one.covariance, 1e-12));
      EXPECT_NEAR(two.y - one.y, 2 * (one.y - half[k].objects[i].y), 0.01);
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(SensorNoise, MarkingsErrMoreThanTheyState) {
  const auto nominal = all<MarkingFeatures>(noisy_drive(1));
  const auto half = all<MarkingFeatures>(noisy_drive(0.5));
  const auto twice = all<MarkingFeatures>(noisy_drive(2));
  std::vector<double> less, more;
  Moments stated, stated_of_twice;
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    ASSERT_DOUBLE_EQ(twice[k].shared_error->sigma, nominal[k].shared_error->sigma);
    const std::size_t count = nominal[k].features.size();
    if (half[k].features.size() != count || twice[k].features.size() != count) continue;
    for (std::size_t i = 0; i < count; ++i) {
      const Feature& one = nominal[k].features[i];
      if (one.x > 30) continue;  // the farther away, the more twice the pitch is more than twice the error
      less.push_back(std::abs(one.heading - half[k].features[i].heading));
      more.push_back(std::abs(twice[k].features[i].heading - one.heading));
      stated.add(std::sqrt(one.covariance(2, 2)));
      stated_of_twice.add(std::sqrt(twice[k].features[i].covariance(2, 2)));
    }
  }
  EXPECT_GT(less.size(), 500U);
  EXPECT_NEAR(percentile(more, 0.5) / percentile(less, 0.5), 2, 0.3);
  EXPECT_NEAR(stated_of_twice.mean() / stated.mean(), 1, 0.03);
}

}  // namespace
}  // namespace lanefuse
