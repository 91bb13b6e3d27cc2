// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/ground_rays.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "simulation/bridges.hpp"
#include "simulation/rendered_scene.hpp"
#include "simulation/texture_tile.hpp"

namespace lanefuse {
namespace {

using testing::Moments;
using testing::RenderedScene;

TEST(RoadAhead, KnowsThePlacesThatTheRoadKnows) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RenderedScene at(seed, RoadKind::sharp);
    const Scene& scene = at.scene();
    const RoadAhead road(scene, 20, 300);
    Random random(seed, "places");
    for (int i = 0; i < 200; ++i) {
      const RoadPlace place{random.uniform(-15, 250), random.uniform(-20, 20)};
      const Eigen::Vector2d exact = (scene.ego.world_from_vehicle.inverse() *
                                     scene.road->pose(scene.ego.station + place.way, place.lateral))
                                        .position();
      EXPECT_LT((road.point(place) - exact).norm(), 1e-3);
      const RoadPlace found = road.place(exact.x(), exact.y(), place.way + random.uniform(-3, 3));
      EXPECT_NEAR(found.way, place.way, 2e-3);
      EXPECT_NEAR(found.lateral, place.lateral, 1e-3);
      EXPECT_NEAR(road.height(place.way),
                  scene.road->height().above_tangent(scene.ego.station, scene.ego.station + place.way), 1e-4);
    }
  }
}

TEST(GroundRays, MeetTheRoadWhereItsPixelsAre) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RenderedScene at(seed);
    const CameraModel camera(high_resolution_camera_intrinsics());
    const RoadAhead road(at.scene(), 20, 460);
    const GroundRays rays(camera, at.mounting(), road);
    const ImageTruth truth(at.scene(), camera, at.mounting());
    Random random(seed, "pixels");
    for (int i = 0; i < 200; ++i) {
      const double way = random.uniform(8, 130);
      const double lateral = random.uniform(-8, 8);
      const auto pixel = truth.pixel(at.scene().ego.station + way, lateral);
      ASSERT_TRUE(pixel);
      const GroundHit hit = rays.cast(*pixel);
      EXPECT_TRUE(hit.ground);
      EXPECT_NEAR(hit.way, way, 1e-3 * way);
      EXPECT_NEAR(hit.lateral, lateral, 2e-3);
    }
    EXPECT_FALSE(rays.cast(Eigen::Vector2d(1280, 10)).ground);
  }
}

TEST(TextureTile, RepeatsAndAveragesOut) {
  const TextureTile tile({64, 64, 0.1}, {{1, 1}, {4, 1}}, 1, "test");
  const TextureTile::Level fine = tile.level(0.1, 0.1);
  const TextureTile::Level coarse = tile.level(3.2, 0.1);
  Moments near, far;
  for (int i = 0; i < 2000; ++i) {
    const double along = i * 0.737;
    const double across = i * 0.211 - 100;
    near.add(fine.at(along, across));
    far.add(coarse.at(along, across));
    EXPECT_NEAR(fine.at(along, across), fine.at(along + 6.4, across - 12.8), 1e-3);
  }
  EXPECT_NEAR(near.mean(), 0, 0.1);
  EXPECT_GT(near.sigma(), 0.4);  // a little less than 1 between the texels
  EXPECT_LT(far.sigma(), 0.4 * near.sigma());
}

TEST(TextureTile, ReadsARunAsItReadsItsPlaces) {
  const TextureTile tile({64, 64, 0.1}, {{2, 1}}, 1, "test");
  const TextureTile::Level level = tile.level(0.1, 0.1);
  std::array<float, 20> values{};
  level.read_run({3.21, -4.5, 0.013, 0.171}, 20, values.data());
  for (int i = 0; i < 20; ++i) {
    EXPECT_NEAR(values.at(static_cast<std::size_t>(i)), level.at(3.21 + i * 0.013, -4.5 + i * 0.171), 2e-3);
  }
}

TEST(Bridges, StandWhereTheyStandWhoeverLooks) {
  const auto all = bridges_over({0, 20'000}, 3);
  EXPECT_GT(all.size(), 5u);
  EXPECT_LT(all.size(), 20u);
  for (const Stretch& bridge : all) {
    EXPECT_EQ(bridges_over({bridge.begin - 50, bridge.begin + 1}, 3), std::vector<Stretch>{bridge});
  }
}

}  // namespace
}  // namespace lanefuse
