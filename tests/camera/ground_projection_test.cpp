// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/ground_projection.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

const CameraModel kCamera({2560, 900, 2875, 2875, 1279.5, 449.5, {-0.05, 0.01, 0, 0, 0}});

CameraPose some_pose(Random& random) {
  CameraPose pose;
  pose.mounting = {0.3,
                   random.uniform(-0.2, 0.2),
                   random.uniform(1.0, 1.8),
                   random.uniform(-0.03, 0.03),
                   random.uniform(-0.03, 0.03),
                   random.uniform(-0.03, 0.03)};
  pose.vertical_curvature = random.uniform(-1e-4, 1e-4);
  return pose;
}

TEST(GroundProjection, PlacesAndPixelsAreInverse) {
  Random random(1, "poses");
  for (int i = 0; i < 500; ++i) {
    const GroundProjection projection(kCamera, some_pose(random));
    const Eigen::Vector2d place(random.uniform(8, 100), random.uniform(-4, 4));
    const auto pixel = projection.pixel(place);
    ASSERT_TRUE(pixel);
    const auto back = projection.ground(*pixel);
    if (!back) continue;  // behind a crest
    EXPECT_LT((*back - place).norm(), 1e-4 * place.x()) << place.transpose();
  }
}

TEST(GroundProjection, FlatRoadIsExact) {
  CameraPose pose;
  pose.mounting.z = 1.25;
  const CameraModel pinhole({100, 100, 1000, 1000, 50, 50, {}});
  const GroundProjection projection(pinhole, pose);
  const auto place = projection.ground({50 - 20, 50 + 25});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x(), 50, 1e-9);
  EXPECT_NEAR(place->y(), 1, 1e-9);
  EXPECT_FALSE(projection.ground({50, 49}));
  EXPECT_NEAR(projection.horizon_row(50), 50, 1e-9);
}

TEST(GroundProjection, NoseDownPutsTheHorizonHigher) {
  CameraPose pose;
  pose.mounting.z = 1.25;
  pose.mounting.pitch = 0.01;
  const CameraModel pinhole({100, 100, 1000, 1000, 50, 50, {}});
  EXPECT_NEAR(GroundProjection(pinhole, pose).horizon_row(50), 40, 0.01);
}

TEST(GroundProjection, JacobiansPredictSmallChanges) {
  Random random(3, "poses");
  for (int i = 0; i < 100; ++i) {
    const CameraPose pose = some_pose(random);
    const GroundProjection projection(kCamera, pose);
    const Eigen::Vector2d place(random.uniform(8, 60), random.uniform(-4, 4));
    const auto pixel = projection.pixel(place);
    const auto jacobians = projection.jacobians(*pixel);
    if (!jacobians) continue;
    CameraPose turned = pose;
    turned.mounting.pitch += 1e-4;
    const auto moved = GroundProjection(kCamera, turned).ground(*pixel);
    if (!moved) continue;
    const Eigen::Vector2d predicted = place + 1e-4 * jacobians->pose.col(2);
    EXPECT_LT((*moved - predicted).norm(), 0.03 * (*moved - place).norm() + 1e-4);
  }
}

}  // namespace
}  // namespace lanefuse
