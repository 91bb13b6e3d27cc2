// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/rail_mirrors.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "simulation/detection_scene.hpp"
#include "simulation/radar_model.hpp"
#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::car;
using testing::SceneRun;

TEST(GuardRails, MirrorAVehicleBeyondThem) {
  const SceneVehicle image = mirrored(car(3, {10, 2, 0.1}, 30, 0.02), {{10, 5, 0}});
  EXPECT_NEAR(image.world_from_vehicle.x, 10, 1e-12);
  EXPECT_NEAR(image.world_from_vehicle.y, 8, 1e-12);
  EXPECT_NEAR(image.world_from_vehicle.heading, -0.1, 1e-12);
  EXPECT_NEAR(image.speed, 30, 1e-12);
  EXPECT_NEAR(image.yaw_rate, -0.02, 1e-12);
}

TEST(GuardRails, MirrorsInABendMoveAsTheirPlaceDoes) {
  // A rail of 400 m radius around (0, 400); the vehicle keeps 6 m inside of it.
  const double curvature = 1.0 / 400;
  const auto at = [&](double seconds) {
    const double angle = 30 * seconds / (400 - 6);
    const Pose2 rail{400 * std::sin(angle), 400 - 400 * std::cos(angle), angle};
    SceneVehicle vehicle = car(1, rail * Pose2{0, 6, 0}, 30, 30.0 / 394);
    return mirrored(vehicle, {rail, curvature});
  };
  const SceneVehicle now = at(0);
  const SceneVehicle later = at(1e-4);
  const Eigen::Vector2d way = later.world_from_vehicle.position() - now.world_from_vehicle.position();
  EXPECT_NEAR(way.norm() / 1e-4, now.speed, 1e-3);
  EXPECT_NEAR((later.world_from_vehicle.heading - now.world_from_vehicle.heading) / 1e-4, now.yaw_rate, 1e-6);
}

TEST(GuardRails, StandBeyondTheOutermostRecordedBoundary) {
  TrueRoad road;
  for (const double y : {7.0, 3.5, -3.5}) {
    road.boundaries.push_back({1, {}, 0.15, {{-100, y}, {0.5, y}, {100, y}}});
  }
  const BoundaryRails rails(road, 3);
  const auto left = rails.beside({}, {0, {20, 1, 0.1}}, 1);
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->world_from_rail.y, 10, 1e-9);
  EXPECT_NEAR(left->world_from_rail.heading, 0, 1e-9);
  const auto right = rails.beside({}, {0, {20, 1, 0.1}}, -1);
  ASSERT_TRUE(right);
  EXPECT_NEAR(right->world_from_rail.y, -6.5, 1e-9);
  EXPECT_FALSE(rails.beside({}, {0, {120, 1, 0}}, 1));
}

/// Ghosts of the long-range radar alone, at most that many a scan.
RadarModel ghost_radar(double most, std::uint64_t seed) {
  SensorPreset preset = testing::exact_detections();
  preset.long_range_radar.detection = 0;
  preset.ghosts.guard_rail_mirrors = {0, most};
  return {long_range_radar_setup(preset, testing::road_rails()), seed};
}

TEST(RailMirrors, LieBeyondTheRailAndMoveAlong) {
  double scans = 0, ghosts = 0, followed = 0, followable = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SceneRun run(seed);
    RadarModel radar = ghost_radar(2, seed);
    std::vector<Eigen::Vector2d> before;
    Time last{};
    run.watch(radar, 30, [&](const Scene& scene, const Measurement& measurement) {
      const auto& seen = std::get<RadarScan>(measurement).detections;
      const double step = to_seconds(scene.time - last);
      last = scene.time;
      ASSERT_LE(seen.size(), 2u);
      scans += 1;
      ghosts += static_cast<double>(seen.size());
      std::vector<Eigen::Vector2d> now;
      for (const RadarDetection& ghost : seen) {
        const Eigen::Vector2d in_ego(0.9 + ghost.range * std::cos(ghost.bearing),
                                     ghost.range * std::sin(ghost.bearing));
        const Eigen::Vector2d place = testing::place_of(scene, in_ego);
        const double beyond = std::max(place.y() - scene.road->guard_rail(1, place.x()),
                                       scene.road->guard_rail(-1, place.x()) - place.y());
        EXPECT_GT(beyond, 1);
        const double speed = scene.ego.speed + ghost.range_rate / std::cos(ghost.bearing);
        EXPECT_GT(speed, 10);
        EXPECT_LT(speed, 60);
        now.push_back(place);
        followable += !before.empty();
        for (const Eigen::Vector2d& earlier : before) {
          const double way = place.x() - earlier.x() - step * speed;
          if (std::abs(way) > 6 || std::abs(place.y() - earlier.y()) > 2) continue;
          followed += 1;
          break;
        }
      }
      before = now;
    });
  }
  EXPECT_GT(ghosts / scans, 0.3);
  EXPECT_LE(ghosts / scans, 1.1);
  EXPECT_GT(followed / followable, 0.7);
}

TEST(RailMirrors, AreAsManyAsAreAskedFor) {
  SceneRun run(2);
  RadarModel none = ghost_radar(0, 2);
  RadarModel many = ghost_radar(50, 2);
  std::size_t fewest = 0, most = 0;
  run.watch(many, 10, [&](const Scene& scene, const Measurement& measurement) {
    most = std::max(most, std::get<RadarScan>(measurement).detections.size());
    fewest += testing::look<RadarScan>(none, scene).detections.size();
  });
  EXPECT_EQ(fewest, 0u);
  EXPECT_GT(most, 2u);
}

}  // namespace
}  // namespace lanefuse
