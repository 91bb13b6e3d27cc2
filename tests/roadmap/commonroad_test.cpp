// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/commonroad.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "roadmap/lane_strips.hpp"
#include "support/map_files.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::replaced;
using testing::ScratchMap;
using testing::survive_damage;
using ::testing::ThrowsMessage;

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

constexpr const char* kTwoLanelets = R"(<?xml version="1.0"?>
<commonRoad commonRoadVersion="2020a" timeStepSize="0.1" benchmarkID="two">
<lanelet id="5">
<leftBound>
<point><x>0</x><y>3.5</y></point>
<point><x>100</x><y>3.5</y></point>
<lineMarking>solid</lineMarking>
</leftBound>
<rightBound>
<point><x>0</x><y>0</y></point>
<point><x>100</x><y>0</y></point>
<lineMarking>dashed</lineMarking>
</rightBound>
<adjacentRight ref="6" drivingDir="same"/>
<adjacentLeft ref="7" drivingDir="opposite"/>
</lanelet>
<lanelet id="6">
<leftBound>
<point><x>0</x><y>0.1</y></point>
<point><x>0</x><y>0.1</y></point>
<point><x>100</x><y>0.1</y></point>
</leftBound>
<rightBound>
<point><x>0</x><y>-3.5</y></point>
<point><x>100</x><y>-3.5</y><z>1</z></point>
<lineMarking>broad_dashed</lineMarking>
</rightBound>
<adjacentLeft ref="5" drivingDir="same"/>
</lanelet>
<lanelet id="7">
<leftBound>
<point><x>100</x><y>3.5</y></point>
<point><x>0</x><y>3.5</y></point>
</leftBound>
<rightBound>
<point><x>100</x><y>7</y></point>
<point><x>0</x><y>7</y></point>
</rightBound>
<adjacentLeft ref="5" drivingDir="opposite"/>
</lanelet>
<dynamicObstacle id="31"><type>truck</type>
<shape><rectangle><length>12</length><width>2.5</width></rectangle></shape>
<initialState><position><point><x>1</x><y>2</y></point></position><orientation><exact>7</exact></orientation>
<time><exact>0</exact></time><velocity><intervalStart>19</intervalStart><intervalEnd>21</intervalEnd></velocity>
</initialState>
<trajectory><state><position><point><x>3</x><y>2</y></point></position><orientation><exact>0</exact></orientation>
<time><exact>1</exact></time><velocity><exact>20</exact></velocity></state></trajectory>
</dynamicObstacle>
</commonRoad>
)";

class CommonRoadText : public ::testing::Test {
 protected:
  static CommonRoadScenario read(const std::string& text) {
    const ScratchMap file("scenario.xml", text);
    return read_commonroad(file.path());
  }
  static void expect_refused(const std::string& from, const std::string& to, const std::string& where,
                             const std::string& what) {
    EXPECT_THAT([&] { read(replaced(kTwoLanelets, from, to)); },
                ThrowsMessage<Error>(AllOf(HasSubstr("scenario.xml, line " + where), HasSubstr(what))));
  }
};

TEST_F(CommonRoadText, NeighboursShareABoundaryDrawnTwice) {
  const RoadMap map = read(kTwoLanelets).map;
  ASSERT_EQ(map.lanes.size(), 3);
  EXPECT_EQ(find_lane(map, 5)->right_boundary, find_lane(map, 6)->left_boundary);
  EXPECT_EQ(find_boundary(map, find_lane(map, 5)->right_boundary)->styles[0].marking.type,
            MarkingType::dashed);
  const MarkingStyle& right = find_boundary(map, find_lane(map, 6)->right_boundary)->styles[0];
  EXPECT_EQ(right.width, 0.3);
  EXPECT_EQ(find_boundary(map, find_lane(map, 6)->right_boundary)->points[1].z(), 1);
}

TEST_F(CommonRoadText, OncomingLanesAreNoNeighbours) {
  const RoadMap map = read(kTwoLanelets).map;
  EXPECT_EQ(find_lane(map, 5)->left_lane, std::nullopt);
  EXPECT_EQ(find_lane(map, 7)->left_lane, std::nullopt);
  EXPECT_NE(find_lane(map, 5)->left_boundary, find_lane(map, 7)->left_boundary);
}

TEST_F(CommonRoadText, ReadsATruck) {
  const RecordedVehicle truck = read(kTwoLanelets).vehicles.at(0);
  EXPECT_EQ(truck.kind, RecordedKind::truck);
  EXPECT_EQ(truck.length, 12);
  EXPECT_NEAR(truck.states[0].heading, 7 - 2 * M_PI, 1e-12);
  EXPECT_EQ(truck.states[0].speed, 20);
  EXPECT_DOUBLE_EQ(truck.states[1].time_s, 0.1);
}

TEST_F(CommonRoadText, RefusalsNameLineAndElement) {
  expect_refused("<point><x>0</x><y>3.5</y>", "<point><x>0</x><y>nan</y>",
                 "5, <lanelet id=5>/<leftBound>/<point>/<y>", "'nan', which is no finite number");
  expect_refused("<point><x>0</x><y>3.5</y></point>", "", "4, <lanelet id=5>/<leftBound>",
                 "fewer than two different points");
  expect_refused("<lanelet id=\"6\">", "<lanelet id=\"5\">", "17, <lanelet id=5>",
                 "the id of another lanelet");
  expect_refused("<lanelet id=\"6\">", "<lanelet>", "17, <lanelet>", "has no attribute 'id'");
  expect_refused("<lanelet id=\"6\">", "<lanelet id=\"six\">", "17, <lanelet id=six>", "no whole number");
  expect_refused("ref=\"6\"", "ref=\"60\"", "14, <lanelet id=5>/<adjacentRight>",
                 "lanelet 60, which is not there");
  expect_refused("broad_dashed", "wavy", "26, <lanelet id=6>/<rightBound>/<lineMarking>",
                 "'wavy' is no line marking");
  expect_refused("drivingDir=\"same\"", "drivingDir=\"up\"", "14, <lanelet id=5>/<adjacentRight>",
                 "'drivingDir'");
  expect_refused("<length>12", "<length>-12", "42, <dynamicObstacle id=31>/<shape>/<rectangle>/<length>",
                 "-12 m");
  expect_refused("<exact>1</exact>", "<exact>0</exact>", "46, <dynamicObstacle id=31>/<trajectory>/<state>",
                 "no later");
  expect_refused("2020a", "2016a", "2, <commonRoad>", "2018b and 2020a are read");
  expect_refused("timeStepSize=\"0.1\"", "timeStepSize=\"0\"", "2, <commonRoad>", "'timeStepSize' is 0");
  expect_refused("</commonRoad>", "", "2", "no sound XML");
  expect_refused("<x>100</x><y>7</y>", "<x>1e99</x><y>7</y>", "36, <lanelet id=7>/<rightBound>/<point>/<x>",
                 "beyond any road");
}

TEST_F(CommonRoadText, DeepNestingIsRefused) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_THAT([&] { read(deep); }, ThrowsMessage<Error>(HasSubstr("no sound XML")));
}

TEST_F(CommonRoadText, TooManyElementsAreRefusedBeforeTheyAreParsed) {
  std::string many = "<commonRoad>";
  for (int i = 0; i < 2'000'001; ++i) many += "<a/>";
  EXPECT_THAT([&] { read(many); }, ThrowsMessage<Error>(HasSubstr("more than 2000000 elements")));
}

TEST_F(CommonRoadText, EntitiesAreNotExpanded) {
  const std::string bomb =
      "<?xml version=\"1.0\"?><!DOCTYPE z [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>" +
      replaced(kTwoLanelets, "<?xml version=\"1.0\"?>\n", "");
  EXPECT_ANY_THROW(read(replaced(bomb, "<x>3</x>", "<x>&b;</x>")));
}

TEST_F(CommonRoadText, DamageNeverCrashes) {
  survive_damage("scenario.xml", kTwoLanelets,
                 [](const std::filesystem::path& path) { check(read_commonroad(path).map, "damaged"); });
}

}  // namespace
}  // namespace lanefuse
