// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/odometry_model.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::Moments;
using testing::SceneRun;

TEST(OdometryModel, ErrsAsThePresetSays) {
  const double degree = std::numbers::pi / 180;
  Moments scales, biases, white;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SceneRun run(1);
    OdometryModel odometry(run.preset().odometry, seed);
    Moments scale, yaw_rate;
    run.watch(odometry, 4, [&](const Scene& scene, const Measurement& measurement) {
      const auto& motion = std::get<VehicleMotion>(measurement);
      scale.add(*motion.speed / scene.ego.speed - 1);
      yaw_rate.add(*motion.yaw_rate - scene.ego.yaw_rate);
    });
    EXPECT_NEAR(scale.sigma(), 0, 1e-6);
    scales.add(scale.mean());
    biases.add(yaw_rate.mean());
    white.add(yaw_rate.sigma());
  }
  EXPECT_NEAR(scales.rms(), 0.005, 0.001);
  EXPECT_NEAR(biases.rms(), 0.03 * degree, 0.006 * degree);
  EXPECT_NEAR(white.mean(), 0.1 * degree, 0.005 * degree);
}

}  // namespace
}  // namespace lanefuse
