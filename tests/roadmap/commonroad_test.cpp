// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/commonroad.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "roadmap/lane_strips.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

std::filesystem::path real_scenario(const char* name) {
  return testing::real_data("commonroad") / (std::string(name) + "_T-1.xml");
}

double length_of(const RoadMap& map, std::size_t boundary) {
  return arc_length(map.boundaries[boundary].points);
}

TEST(CommonRoad, ReadsTheA99) {
  const auto path = real_scenario("DEU_A99-1_1");
  LANEFUSE_NEEDS_DATA(path);
  const CommonRoadScenario scenario = read_commonroad(path);
  ASSERT_EQ(scenario.map.lanes.size(), 3);
  ASSERT_EQ(scenario.map.boundaries.size(), 4);  // neighbours share theirs
  EXPECT_EQ(scenario.map.lanes[0].id, 47625);    // the leftmost
  EXPECT_EQ(scenario.map.lanes[1].left_lane, 47625);
  EXPECT_EQ(scenario.map.lanes[1].right_lane, 47629);
  EXPECT_NEAR(length_of(scenario.map, 0), 2454, 1);
  EXPECT_EQ(scenario.map.origin, std::nullopt);
  EXPECT_EQ(scenario.time_step, 0.1);
}

TEST(CommonRoad, ReadsTheA9WhichStandsFromRightToLeft) {
  const auto path = real_scenario("DEU_A9-2_1");
  LANEFUSE_NEEDS_DATA(path);
  const CommonRoadScenario scenario = read_commonroad(path);
  ASSERT_EQ(scenario.map.lanes.size(), 3);
  EXPECT_EQ(scenario.map.boundaries.size(), 4);
  EXPECT_EQ(scenario.map.lanes[0].id, 30626);
  EXPECT_EQ(scenario.map.lanes[2].id, 30622);
  EXPECT_EQ(scenario.map.lanes[2].right_lane, std::nullopt);
}

TEST(CommonRoad, ReadsTheTrafficOfUs101) {
  const auto path = real_scenario("USA_US101-15_1");
  LANEFUSE_NEEDS_DATA(path);
  const CommonRoadScenario scenario = read_commonroad(path);
  ASSERT_EQ(scenario.vehicles.size(), 37);
  const RecordedVehicle& first = scenario.vehicles[0];
  EXPECT_EQ(first.id, 415);
  EXPECT_EQ(first.kind, RecordedKind::car);
  EXPECT_EQ(first.length, 5.0292);
  EXPECT_EQ(first.width, 2.1031);
  EXPECT_EQ(first.states[0].x, 83.2994);
  EXPECT_DOUBLE_EQ(first.states[2].time_s, 0.2);
  EXPECT_NEAR(scenario.map.origin.value().latitude_deg, 34.13817, 1e-9);
}

/// Lanelets of 107 m and 77 m follow one another: their boundaries must run on.
TEST(CommonRoad, LaneletsThatFollowMakeOneLongLane) {
  const auto path = real_scenario("USA_US101-15_1");
  LANEFUSE_NEEDS_DATA(path);
  const RoadMap map = read_commonroad(path).map;
  EXPECT_EQ(map.lanes[0].id, 30);
  EXPECT_NEAR(length_of(map, 0), 106.5 + 77.3, 0.2);
  EXPECT_EQ(map.boundaries[0].styles.size(), 1);
  EXPECT_EQ(map.boundaries[0].styles[0].marking.type, MarkingType::solid);
  EXPECT_EQ(map.boundaries[0].styles[0].width, 0.3);
  EXPECT_EQ(find_lane(map, 20)->right_boundary, find_boundary(map, find_lane(map, 20)->right_boundary)->id);
  EXPECT_EQ(find_lane(map, 28), nullptr);  // continues lane 30
}

/// Whether a point lies between two boundaries: left of the one's nearest piece, right of the other's.
double side_of(const MapBoundary& boundary, double x, double y) {
  double nearest = std::numeric_limits<double>::infinity();
  double side = 0;
  for (std::size_t i = 1; i < boundary.points.size(); ++i) {
    const Eigen::Vector2d from = boundary.points[i - 1].head<2>();
    const Eigen::Vector2d along = boundary.points[i].head<2>() - from;
    const Eigen::Vector2d to_point = Eigen::Vector2d(x, y) - from;
    const double share = std::clamp(to_point.dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (to_point - share * along).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    side = along.x() * to_point.y() - along.y() * to_point.x();
  }
  return side;
}

bool is_in_a_lane(const RoadMap& map, const RecordedState& state) {
  return std::any_of(map.lanes.begin(), map.lanes.end(), [&](const MapLane& lane) {
    return side_of(*find_boundary(map, lane.left_boundary), state.x, state.y) <= 0 &&
           side_of(*find_boundary(map, lane.right_boundary), state.x, state.y) >= 0;
  });
}

TEST(CommonRoad, TheTrafficOfUs101IsInItsLanes) {
  for (const char* name : {"USA_US101-24_2", "USA_US101-8_1", "USA_US101-4_1"}) {
    const auto path = real_scenario(name);
    LANEFUSE_NEEDS_DATA(path);
    const CommonRoadScenario scenario = read_commonroad(path);
    std::size_t in_lane = 0;
    std::size_t all = 0;
    for (const RecordedVehicle& vehicle : scenario.vehicles) {
      for (const RecordedState& state : vehicle.states) in_lane += is_in_a_lane(scenario.map, state) ? 1 : 0;
      all += vehicle.states.size();
    }
    EXPECT_GT(static_cast<double>(in_lane), 0.98 * static_cast<double>(all)) << name;
  }
}

/// Where a lane runs between the same boundaries but for a part, its ends are told by a boundary's end.
TEST(CommonRoad, TheEntryOfUs101BeginsWhereItsRightBoundaryDoes) {
  const auto path = real_scenario("USA_US101-24_2");
  LANEFUSE_NEEDS_DATA(path);
  const RoadMap map = read_commonroad(path).map;
  const MapLane* entry = find_lane(map, 92);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->left_lane, 91);
  EXPECT_EQ(entry->left_boundary, find_lane(map, 91)->right_boundary);
  EXPECT_NEAR(arc_length(find_boundary(map, entry->right_boundary)->points), 212.4 + 19.9, 0.5);
  const MapBoundary* shared = find_boundary(map, entry->left_boundary);
  EXPECT_EQ(style_at(*shared, 20).marking.type, MarkingType::solid);
  EXPECT_EQ(style_at(*shared, 60).marking.type, MarkingType::dashed);
  EXPECT_EQ(find_lane(map, 16)->successors, std::vector<std::uint64_t>{92});
}

}  // namespace
}  // namespace lanefuse
