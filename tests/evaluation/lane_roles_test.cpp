// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/lane_roles.hpp"

#include <gtest/gtest.h>

#include "evaluation/true_road_view.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::RoadScene;

/// A line along the x axis of the world, with a point a metre.
TrueBoundary straight(std::uint64_t id, double from, double to, double y) {
  TrueBoundary boundary;
  boundary.id = id;
  for (double x = from; x <= to; ++x) boundary.points.emplace_back(x, y);
  return boundary;
}

/// From y at `from` to y_end at `to`.
TrueBoundary slanted(std::uint64_t id, double from, double to, double y, double y_end) {
  TrueBoundary boundary = straight(id, from, to, y);
  for (auto& point : boundary.points) point.y() += (y_end - y) * (point.x() - from) / (to - from);
  return boundary;
}

TrueRoles roles_of(const TrueRoad& road, const Pose2& world_from_vehicle = {}) {
  TrueRoadView view(road);
  return TrueLanes(road).roles(view.look_from(world_from_vehicle));
}

TEST(TrueLanes, NamesTheEdgesOfTheOwnAndTheNeighbourLanes) {
  const RoadScene scene;
  const TrueRoles roles = roles_of(testing::true_road(scene), scene.world_from_vehicle);
  EXPECT_NEAR(*roles[kEgoLeft].y(30), scene.boundary(1).y(30), 1e-2);
  EXPECT_NEAR(*roles[kEgoRight].y(30), scene.boundary(2).y(30), 1e-2);
  EXPECT_NEAR(*roles[kAdjacentLeft].y(30), scene.boundary(0).y(30), 1e-2);
  EXPECT_NEAR(*roles[kAdjacentRight].y(30), scene.boundary(3).y(30), 1e-2);
}

TEST(TrueLanes, HaveNoRolesForACarThatIsInNone) {
  const RoadScene scene;
  for (const RoleLine& role :
       roles_of(testing::true_road(scene), scene.world_from_vehicle * Pose2{0, 50, 0})) {
    EXPECT_TRUE(role.empty());
  }
}

/// The own lane between 1.8 and -1.8, and right of it an exit lane that begins 40 m ahead: its outer line
/// leaves the edge there and is a lane's width away at 80 m.
TrueRoad with_exit_lane(bool linked) {
  TrueRoad road;
  road.boundaries = {straight(1, -60, 300, 1.8), straight(2, -60, 300, -1.8), slanted(3, 40, 80, -1.8, -5.3)};
  const TrueBoundary far = straight(3, 81, 300, -5.3);
  auto& points = road.boundaries[2].points;
  points.insert(points.end(), far.points.begin(), far.points.end());
  road.lanes = {{1, 1, 2, {}, {}}, {2, 2, 3, {}, {}}};
  if (linked) {
    road.lanes[0].right_lane = 2;
    road.lanes[1].left_lane = 1;
  }
  return road;
}

TEST(TrueLanes, ANeighbourIsAskedForWhereItIsWideEnoughToDriveIn) {
  const TrueRoles roles = roles_of(with_exit_lane(true));
  EXPECT_FALSE(roles[kAdjacentRight].y(0));
  EXPECT_FALSE(roles[kAdjacentRight].y(60));  // 1.75 m wide there
  ASSERT_TRUE(roles[kAdjacentRight].y(70));
  EXPECT_NEAR(*roles[kAdjacentRight].y(70), -1.8 - 3.5 * 0.75, 1e-9);
  EXPECT_NEAR(*roles[kAdjacentRight].y(120), -5.3, 1e-9);
  EXPECT_TRUE(roles[kAdjacentLeft].empty());
}

TEST(TrueLanes, LanesThatShareTheBoundaryBetweenAreNeighboursWithoutALink) {
  EXPECT_TRUE(roles_of(with_exit_lane(false))[kAdjacentRight].y(120));
}

TEST(TrueLanes, TwoNeighboursOneBehindTheOtherAreBothAskedFor) {
  TrueRoad road = with_exit_lane(true);
  road.boundaries.push_back(straight(4, -60, 20, -5.3));  // an entry lane that ends 20 m ahead
  road.lanes.push_back({3, 2, 4, 1, {}});
  const TrueRoles roles = roles_of(road);
  EXPECT_TRUE(roles[kAdjacentRight].y(10));
  EXPECT_FALSE(roles[kAdjacentRight].y(30));
  EXPECT_TRUE(roles[kAdjacentRight].y(100));
}

TEST(TrueLanes, GoOnAsTheLaneThatBeginsWhereTheirsEnds) {
  TrueRoad road;
  road.boundaries = {straight(1, -60, 50, 1.8), straight(2, -60, 300, -1.8), straight(3, 50, 300, 1.9),
                     straight(4, 50, 300, 5.4)};
  road.lanes = {{1, 1, 2, {}, {}}, {2, 3, 2, {}, {}}, {3, 4, 3, {}, {}}};
  const TrueRoles roles = roles_of(road);
  EXPECT_NEAR(*roles[kEgoLeft].y(40), 1.8, 1e-9);
  EXPECT_NEAR(*roles[kEgoLeft].y(120), 1.9, 1e-9);
  EXPECT_NEAR(*roles[kEgoRight].y(120), -1.8, 1e-9);
  EXPECT_FALSE(roles[kAdjacentLeft].y(40));
  EXPECT_NEAR(*roles[kAdjacentLeft].y(120), 5.4, 1e-9);
}

TEST(TrueLanes, EndWhereTheyEnd) {
  TrueRoad road;
  road.boundaries = {straight(1, -60, 300, 1.8), slanted(2, -60, 60, -1.8, 1.8)};
  road.lanes = {{1, 1, 2, {}, {}}};
  const TrueRoles roles = roles_of(road);
  EXPECT_TRUE(roles[kEgoRight].y(50));
  EXPECT_FALSE(roles[kEgoRight].y(70));
}

TEST(TrueLanes, LinesThatBoundNoLaneAreNoBoundaries) {
  TrueRoad road = with_exit_lane(true);
  road.boundaries.push_back(straight(9, -60, 300, 0.4));  // old paint in the middle of the lane
  const TrueLanes lanes(road);
  EXPECT_TRUE(lanes.bounds_a_lane(0));
  EXPECT_FALSE(lanes.bounds_a_lane(3));
  EXPECT_NEAR(*roles_of(road)[kEgoLeft].y(0), 1.8, 1e-9);
}

TEST(TrueLanes, ALaneWithoutABoundaryIsLeftOut) {
  TrueRoad road = with_exit_lane(true);
  road.lanes.push_back({7, 77, 1, {}, 1});
  EXPECT_EQ(TrueLanes(road).lanes().size(), 2U);
  EXPECT_TRUE(roles_of(road)[kAdjacentLeft].empty());
}

TEST(RoleLine, MeasuresAcrossThePieceThatIsThere) {
  LineAhead near, far;
  for (const double x : {0.0, 50.0}) near.extend({x, 1});
  for (const double x : {60.0, 120.0}) far.extend({x, 2});
  RoleLine line;
  line.add(near);
  line.add(far);
  EXPECT_NEAR(*line.deviation({30, 1.5}), 0.5, 1e-12);
  EXPECT_NEAR(*line.deviation({90, 1.5}), -0.5, 1e-12);
  EXPECT_FALSE(line.deviation({55, 1.5}));
}

}  // namespace
}  // namespace lanefuse
