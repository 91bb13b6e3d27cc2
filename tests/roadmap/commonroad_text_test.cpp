// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "roadmap/commonroad.hpp"
#include "support/map_files.hpp"

namespace lanefuse {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::replaced;
using testing::ScratchMap;
using testing::survive_damage;
using ::testing::ThrowsMessage;

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
  expect_refused("<exact>1</exact>", "<exact>1e9</exact>", "46, <dynamicObstacle id=31>/<trajectory>/<state>",
                 "more than 1000 s or 20000 m");
  expect_refused("<point><x>3</x>", "<point><x>3e9</x>", "46, <dynamicObstacle id=31>/<trajectory>/<state>",
                 "more than 1000 s or 20000 m");
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
  for (int i = 0; i < 3'000'001; ++i) many += "<a/>";
  EXPECT_THAT([&] { read(many); }, ThrowsMessage<Error>(HasSubstr("more than 3000000 elements")));
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
