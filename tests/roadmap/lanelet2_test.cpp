// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/lanelet2.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "roadmap/commonroad.hpp"
#include "roadmap/lane_strips.hpp"
#include "support/map_comparison.hpp"
#include "support/map_files.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

using ::testing::AllOf;
using testing::expect_same_lanes;
using ::testing::HasSubstr;
using testing::replaced;
using testing::ScratchMap;
using testing::survive_damage;
using ::testing::ThrowsMessage;

/// Two lanes beside each other, the left one going on in a third lanelet. Way 13 is drawn backwards.
constexpr const char* kLanelets = R"(<?xml version="1.0"?>
<osm version="0.6">
<node id="1" lat="0" lon="0"><tag k="local_x" v="0"/><tag k="local_y" v="7"/></node>
<node id="2" lat="0" lon="0"><tag k="local_x" v="50"/><tag k="local_y" v="7"/><tag k="ele" v="2.5"/></node>
<node id="3" lat="0" lon="0"><tag k="local_x" v="0"/><tag k="local_y" v="3.5"/></node>
<node id="4" lat="0" lon="0"><tag k="local_x" v="50"/><tag k="local_y" v="3.5"/></node>
<node id="5" lat="0" lon="0"><tag k="local_x" v="0"/><tag k="local_y" v="0"/></node>
<node id="6" lat="0" lon="0"><tag k="local_x" v="50"/><tag k="local_y" v="0"/></node>
<node id="7" lat="0" lon="0"><tag k="local_x" v="80"/><tag k="local_y" v="7"/></node>
<node id="8" lat="0" lon="0"><tag k="local_x" v="80"/><tag k="local_y" v="3.5"/></node>
<way id="11"><nd ref="1"/><nd ref="2"/><tag k="type" v="line_thick"/><tag k="subtype" v="solid"/></way>
<way id="12"><nd ref="3"/><nd ref="4"/><tag k="type" v="line_thin"/><tag k="subtype" v="dashed"/><tag k="color" v="yellow"/></way>
<way id="13"><nd ref="6"/><nd ref="5"/><tag k="type" v="guard_rail"/></way>
<way id="14"><nd ref="2"/><nd ref="7"/><tag k="type" v="road_border"/></way>
<way id="15"><nd ref="4"/><nd ref="8"/><tag k="type" v="virtual"/></way>
<relation id="21"><member type="way" ref="11" role="left"/><member type="way" ref="12" role="right"/>
<tag k="type" v="lanelet"/><tag k="subtype" v="highway"/></relation>
<relation id="22"><member type="way" ref="12" role="left"/><member type="way" ref="13" role="right"/>
<tag k="type" v="lanelet"/><tag k="subtype" v="emergency_lane"/></relation>
<relation id="23"><member type="way" ref="14" role="left"/><member type="way" ref="15" role="right"/>
<tag k="type" v="lanelet"/><tag k="subtype" v="highway"/></relation>
<relation id="24"><tag k="type" v="regulatory_element"/></relation>
</osm>
)";

RoadMap read(const std::string& text) {
  const ScratchMap file("map.osm", text);
  return read_lanelet2(file.path());
}

TEST(Lanelet2, SharedWaysMakeNeighbours) {
  const RoadMap map = read(kLanelets);
  ASSERT_EQ(map.lanes.size(), 2);
  EXPECT_EQ(map.lanes[0].id, 21);
  EXPECT_EQ(map.lanes[0].right_lane, 22);
  EXPECT_EQ(map.lanes[1].left_lane, 21);
  EXPECT_EQ(map.lanes[1].kind, LaneKind::emergency);
  EXPECT_EQ(map.lanes[0].right_boundary, map.lanes[1].left_boundary);
}

TEST(Lanelet2, SharedNodesMakeLongLanes) {
  const RoadMap map = read(kLanelets);
  const MapBoundary& left = *find_boundary(map, map.lanes[0].left_boundary);
  EXPECT_NEAR(arc_length(left.points), 80, 0.2);
  EXPECT_EQ(left.points[1].z(), 2.5);
  ASSERT_EQ(left.styles.size(), 2);
  EXPECT_EQ(left.styles[0].marking.type, MarkingType::solid);
  EXPECT_EQ(left.styles[0].width, 0.3);
  EXPECT_EQ(left.styles[1].marking.type, MarkingType::road_edge);
  const MapBoundary& middle = *find_boundary(map, map.lanes[0].right_boundary);
  EXPECT_EQ(middle.styles[0].marking, (MarkingEvidence{MarkingType::dashed, MarkingColour::yellow}));
}

TEST(Lanelet2, WaysDrawnBackwardsAreTurned) {
  const RoadMap map = read(kLanelets);
  const MapBoundary& right = *find_boundary(map, map.lanes[1].right_boundary);
  EXPECT_EQ(right.points.front().x(), 0);
  EXPECT_EQ(right.points.back().x(), 50);
  EXPECT_EQ(right.styles[0].marking.type, MarkingType::guard_rail);
}

TEST(Lanelet2, BoundsOnTheWrongSidesTurnTheLane) {
  const RoadMap map =
      read(replaced(replaced(kLanelets, "ref=\"14\" role=\"left\"", "ref=\"14\" role=\"right\""),
                    "ref=\"15\" role=\"right\"", "ref=\"15\" role=\"left\""));
  const MapLane* turned = find_lane(map, 23);
  ASSERT_NE(turned, nullptr);
  EXPECT_EQ(find_boundary(map, turned->left_boundary)->points.front().x(), 80);
}

TEST(Lanelet2, WayThatManyLaneletsShareCannotFillTheMemory) {
  std::string long_way = "<way id=\"11\">";
  for (int i = 0; i < 20'000; ++i) long_way += "<nd ref=\"1\"/><nd ref=\"2\"/>";
  std::string lanelets;
  for (int i = 0; i < 60; ++i) {
    lanelets += fmt::format(
        "<relation id=\"{}\"><member type=\"way\" ref=\"11\" role=\"left\"/>"
        "<member type=\"way\" ref=\"12\" role=\"right\"/><tag k=\"type\" v=\"lanelet\"/></relation>\n",
        100 + i);
  }
  const std::string text =
      replaced(replaced(kLanelets, "<way id=\"11\">", long_way), "</osm>", lanelets + "</osm>");
  EXPECT_THAT([&] { read(text); }, ThrowsMessage<Error>(AllOf(HasSubstr("<relation id=148>/<member>"),
                                                              HasSubstr("more than 2000000 points"))));
}

TEST(Lanelet2, LatAndLonAreUsedWhereTheyAreKnown) {
  std::string text = kLanelets;
  for (int i = 0; i < 8; ++i) {
    text = replaced(text, "lat=\"0\" lon=\"0\"",
                    fmt::format("lat=\"{}\" lon=\"{}\"", 48 + i * 1e-3, 11 + (i % 3) * 1e-4));
  }
  const RoadMap map = read(text);
  ASSERT_TRUE(map.origin.has_value());
  EXPECT_EQ(map.origin->latitude_deg, 48);
  const auto [least, most] =
      std::minmax_element(map.boundaries[0].points.begin(), map.boundaries[0].points.end(),
                          [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.y() < b.y(); });
  EXPECT_GT(most->y() - least->y(), 100);  // 1e-3 deg are 111 m
}

TEST(Lanelet2, RealLaneletsSurviveWriting) {
  for (const char* name :
       {"DEU_A99-1_1", "DEU_A9-2_1", "USA_US101-11_4", "USA_US101-15_1", "USA_US101-24_2"}) {
    SCOPED_TRACE(name);
    const auto path = testing::real_data("commonroad") / (std::string(name) + "_T-1.xml");
    LANEFUSE_NEEDS_DATA(path);
    const RoadMap map = read_commonroad(path).map;
    const RoadMap again = read(lanelet2_text(map));
    expect_same_lanes(map, again, 0.01);
    EXPECT_EQ(again.lanes[0].id, map.lanes[0].id);
  }
}

void expect_refused(const std::string& from, const std::string& to, const std::string& where,
                    const std::string& what) {
  EXPECT_THAT([&] { read(replaced(kLanelets, from, to)); },
              ThrowsMessage<Error>(AllOf(HasSubstr("map.osm, line " + where), HasSubstr(what))));
}

TEST(Lanelet2, RefusalsNameLineAndElement) {
  expect_refused("<nd ref=\"1\"/>", "<nd ref=\"99\"/>", "11, <way id=11>/<nd>",
                 "node 99, which is not there");
  expect_refused("ref=\"12\" role=\"right\"", "ref=\"98\" role=\"right\"", "16, <relation id=21>/<member>",
                 "way 98, which is not there");
  expect_refused("role=\"left\"", "role=\"lift\"", "16, <relation id=21>", "no member with the role 'left'");
  expect_refused("role=\"right\"", "role=\"left\"", "16, <relation id=21>/<member>",
                 "is a second left bound");
  expect_refused("<nd ref=\"1\"/>", "", "11, <way id=11>", "fewer than two different points");
  expect_refused("k=\"local_x\"", "k=\"lokal_x\"", "3, <node id=1>", "neither a place on Earth");
  expect_refused("k=\"local_x\" v=\"0\"", "k=\"local_x\" v=\"inf\"", "3, <node id=1>",
                 "'inf', which is no length");
  expect_refused("lat=\"0\"", "lat=\"91\"", "3, <node id=1>", "'lat' is 91");
  expect_refused("<node id=\"2\"", "<node id=\"1\"", "4, <node id=1>", "the id of another node");
  expect_refused("<way id=\"12\"", "<way id=\"11\"", "12, <way id=11>", "the id of another way");
  expect_refused("relation id=\"22\"", "relation id=\"21\"", "18, <relation id=21>",
                 "the id of another lanelet");
  expect_refused("relation id=\"22\"", "relation id=\"-2\"", "18, <relation id=-2>", "below 1");
}

TEST(Lanelet2, DamageNeverCrashes) {
  survive_damage("map.osm", kLanelets,
                 [](const std::filesystem::path& path) { check(read_lanelet2(path), "damaged"); });
}

}  // namespace
}  // namespace lanefuse
