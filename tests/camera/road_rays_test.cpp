// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_rays.hpp"

#include <gtest/gtest.h>

#include "camera/ground_projection.hpp"
#include "core/random.hpp"

namespace lanefuse {
namespace {

const CameraModel kCamera({2560, 900, 2875, 2875, 1279.5, 449.5, {-0.05, 0.01, 0.001, -0.001, 0}});

CameraPose some_pose(Random& random) {
  CameraPose pose;
  pose.mounting = {random.uniform(-1, 1),       random.uniform(-0.2, 0.2),   random.uniform(1.0, 1.8),
                   random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03)};
  pose.vertical_curvature = random.uniform(-1e-4, 1e-4);
  return pose;
}

/// Calls `judge` with a camera's rays, its projection and a pixel of the road, many times.
template <typename Judge>
void at_random_places(Judge judge) {
  Random random(5, "places");
  int judged = 0;
  for (int i = 0; i < 300; ++i) {
    const CameraPose pose = some_pose(random);
    const GroundProjection projection(kCamera, pose);
    const auto pixel = projection.pixel({random.uniform(8, 90), random.uniform(-6, 6)});
    if (!pixel || !projection.jacobians(*pixel)) continue;
    judge(RoadRays(kCamera, pose), projection, *pixel);
    ++judged;
  }
  EXPECT_GT(judged, 200);
}

TEST(RoadRays, MeetTheRoadWhereTheProjectionSays) {
  at_random_places(
      [](const RoadRays& rays, const GroundProjection& projection, const Eigen::Vector2d& pixel) {
        const auto hit = rays.hit(pixel);
        ASSERT_TRUE(hit);
        EXPECT_LT((hit->ground - *projection.ground(pixel)).norm(), 1e-9 * hit->ground.norm());
      });
}

TEST(RoadRays, JacobiansAreTheProjectionsOwn) {
  at_random_places(
      [](const RoadRays& rays, const GroundProjection& projection, const Eigen::Vector2d& pixel) {
        const auto expected = projection.jacobians(pixel);
        const auto hit = rays.hit(pixel);
        const RoadRays::PerPose per_pose = rays.per_pose(hit->ground);
        EXPECT_LT((hit->per_pixel - expected->pixel).norm(), 1e-3 * expected->pixel.norm());
        for (int i = 0; i < 4; ++i) {
          const Eigen::Vector2d column = expected->pose.col(i);
          EXPECT_LT((per_pose.col(i) - column).norm(), 1e-3 * column.norm() + 1e-6) << i;
        }
        EXPECT_LT((per_pose.col(4) - expected->vertical_curvature).norm(),
                  1e-3 * expected->vertical_curvature.norm());
      });
}

TEST(RoadRays, SkyHasNoPlaceOnTheRoad) {
  CameraPose pose;
  pose.mounting.z = 1.25;
  const RoadRays rays(kCamera, pose);
  EXPECT_FALSE(rays.hit({1280, 440}));
  EXPECT_TRUE(rays.hit({1280, 480}));
}

}  // namespace
}  // namespace lanefuse
