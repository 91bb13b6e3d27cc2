// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulation/ground_view.hpp"
#include "simulation/line_of_sight.hpp"
#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

CameraPosePreset still_camera() { return {1.25, 0, 1, 0, 1}; }

TEST(GroundView, SeesAFlatRoadAsItIs) {
  Random random(1, "test");
  const GroundView view(still_camera(), random);
  const auto seen = view.see({60, -5}, 0, {});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x(), 60, 1e-9);
  EXPECT_NEAR(seen->y(), -5, 1e-9);
}

TEST(GroundView, TakesAHillForDistance) {
  Random random(1, "test");
  const GroundView view(still_camera(), random);
  const auto seen = view.see({100, 4}, 0.125, {});  // a tenth of the camera's height
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x(), 100 / 0.9, 1e-9);
  EXPECT_NEAR(seen->y(), 4 / 0.9, 1e-9);
  EXPECT_FALSE(view.see({100, 4}, 1.3, {}));  // above the horizon
}

TEST(GroundView, OneTenthOfADegreeIsSeventeenPercentAt120Metres) {
  Random random(1, "test");
  const GroundView view(still_camera(), random);
  const auto seen = view.see({120, 0}, 0, {0.1 * std::numbers::pi / 180, 0});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(1 - seen->x() / 120, 0.143, 0.001);  // 1/(1 + .168): 17 % of the dip
}

TEST(GroundView, ColumnsAreAngles) {
  Random random(1, "test");
  const GroundView view(still_camera(), random);
  const auto seen = view.see({50, 2}, 0, {0, 0.002});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->y(), 2.1, 1e-9);
}

Scene scene_with(std::initializer_list<Eigen::Vector2d> rears) {
  Scene scene;
  std::int64_t id = 1;
  for (const Eigen::Vector2d& rear : rears) {
    SceneVehicle vehicle;
    vehicle.id = id++;
    vehicle.world_from_vehicle = {rear.x(), rear.y(), 0};
    vehicle.front = 4.5;
    vehicle.width = 1.8;
    scene.vehicles.push_back(vehicle);
  }
  return scene;
}

TEST(LineOfSight, AVehicleHidesWhatIsBehindIt) {
  const Scene scene = scene_with({{20, 0}, {50, 0}, {50, 3.6}});
  const LineOfSight sight(scene);
  EXPECT_TRUE(sight.blocked({50, 0}, 2));
  EXPECT_FALSE(sight.blocked({50, 3.6}, 3));
  EXPECT_FALSE(sight.blocked({20, 0}, 1)) << "nothing hides itself";
  EXPECT_FALSE(sight.blocked({15, 0}));
  EXPECT_TRUE(sight.blocked({60, 2.4}));
  EXPECT_FALSE(sight.blocked({49, 2.6})) << "between the lanes one sees far";
}

TEST(LineOfSight, WorksBehindTheCarToo) {
  const Scene scene = scene_with({{-30, 0.2}});
  const LineOfSight sight(scene);
  EXPECT_TRUE(sight.blocked({-60, 0}));
  EXPECT_FALSE(sight.blocked({60, 0}));
}

}  // namespace
}  // namespace lanefuse
