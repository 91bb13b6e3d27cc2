// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_sight.hpp"

#include <gtest/gtest.h>

#include "camera/ground_projection.hpp"
#include "core/random.hpp"
#include "painted_road.hpp"

namespace lanefuse {
namespace {

const CameraModel kCamera(serial_camera());

CameraPose some_pose(Random& random) {
  CameraPose pose;
  pose.mounting = {random.uniform(-2, 1),       random.uniform(-0.3, 0.3),   random.uniform(1, 2),
                   random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03)};
  return pose;
}

TEST(RoadSight, AgreesWithGroundProjection) {
  Random random(1, "poses");
  for (int i = 0; i < 300; ++i) {
    CameraPose pose = some_pose(random);
    const RoadSight sight(kCamera, pose);
    const double pitch = random.uniform(-0.02, 0.02);
    const double bend = random.uniform(-1e-4, 1e-4);
    pose.mounting.pitch += pitch;
    pose.vertical_curvature = bend;
    const GroundProjection projection(kCamera, pose);
    const Eigen::Vector2d place(random.uniform(8, 90), random.uniform(-5, 5));
    const auto pixel = sight.pixel(place, pitch, bend);
    ASSERT_TRUE(pixel);
    EXPECT_LT((*pixel - *projection.pixel(place)).norm(), 1e-6);
    const auto expected = projection.ground(*pixel);
    const auto landing = sight.landing(sight.ray(*pixel), pitch, bend);
    ASSERT_EQ(expected.has_value(), landing.has_value());
    if (landing) {
      EXPECT_LT((landing->place - *expected).norm(), 1e-6);
    }
  }
}

TEST(RoadSight, DerivativesEqualFiniteDifferences) {
  Random random(2, "poses");
  for (int i = 0; i < 200; ++i) {
    const RoadSight sight(kCamera, some_pose(random));
    const double bend = random.uniform(-5e-5, 5e-5);
    const auto pixel = sight.pixel({random.uniform(8, 60), random.uniform(-5, 5)}, 0.002, bend);
    ASSERT_TRUE(pixel);
    const auto at = [&](double column, double pitch, double curvature) {
      return sight.landing(sight.ray({pixel->x() + column, pixel->y()}), 0.002 + pitch, bend + curvature)
          ->place;
    };
    const auto landing = sight.landing(sight.ray(*pixel), 0.002, bend);
    ASSERT_TRUE(landing);
    const auto near = [](const Eigen::Vector2d& derivative, const Eigen::Vector2d& difference) {
      return (derivative - difference).norm() < 1e-3 * (1e-3 + difference.norm());
    };
    EXPECT_TRUE(near(landing->per_column, (at(1e-3, 0, 0) - at(-1e-3, 0, 0)) / 2e-3));
    EXPECT_TRUE(near(landing->per_pitch, (at(0, 1e-6, 0) - at(0, -1e-6, 0)) / 2e-6));
    EXPECT_TRUE(near(landing->per_vertical_curvature, (at(0, 0, 1e-8) - at(0, 0, -1e-8)) / 2e-8));
  }
}

}  // namespace
}  // namespace lanefuse
