// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "roadmap/lane_strips.hpp"
#include "roadmap/opendrive.hpp"
#include "support/map_files.hpp"
#include "support/opendrive_text.hpp"

namespace lanefuse {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using namespace testing;  // the words of OpenDRIVE

RoadMap read(const std::string& text) {
  const ScratchMap file("map.xodr", text);
  return read_opendrive(file.path());
}

std::string mark(double from, const std::string& type, const std::string& colour = "white") {
  return fmt::format("<roadMark sOffset=\"{}\" type=\"{}\" weight=\"bold\" color=\"{}\"/>\n", from, type,
                     colour);
}

TEST(OpenDriveLanes, LeftLanesAreDrivenBackwards) {
  const RoadMap map =
      read(opendrive(road(1, 100, straight(100), section(0, lane(-1, width(3)), lane(1, width(4))))));
  ASSERT_EQ(map.lanes.size(), 2);
  for (const MapLane& lane : map.lanes) {
    const auto& left = find_boundary(map, lane.left_boundary)->points;
    const auto& right = find_boundary(map, lane.right_boundary)->points;
    EXPECT_NEAR(left.front().y(), 0, 1e-9);  // the centre is to the left of both
    const bool is_forward = right.front().y() < 0;
    EXPECT_NEAR(right.front().y(), is_forward ? -3 : 4, 1e-9);
    EXPECT_EQ(left.front().x() < left.back().x(), is_forward);
    EXPECT_EQ(lane.left_lane, std::nullopt);
  }
}

TEST(OpenDriveLanes, InLeftHandTrafficRightLanesAre) {
  const RoadMap map = read(opendrive(
      road(1, 100, straight(100), section(0, lane(-1, width(3)) + lane(-2, width(4))), "", "rule=\"LHT\"")));
  ASSERT_EQ(map.lanes.size(), 2);
  EXPECT_GT(map.boundaries[0].points.front().x(), map.boundaries[0].points.back().x());
  EXPECT_NEAR(map.boundaries[0].points.front().y(), -7, 1e-9);  // the outermost is the leftmost
  EXPECT_EQ(map.lanes[0].right_lane, map.lanes[1].id);
}

TEST(OpenDriveLanes, MarksChangeAlongTheWay) {
  const std::string marks = mark(0, "broken") + mark(30, "solid broken", "yellow");
  const RoadMap map = read(opendrive(road(1, 100, straight(100), section(0, lane(-1, width(3) + marks)))));
  const std::vector<MarkingStyle>& styles = map.boundaries[1].styles;
  ASSERT_EQ(styles.size(), 2);
  EXPECT_EQ(styles[0].marking, (MarkingEvidence{MarkingType::dashed, MarkingColour::white}));
  EXPECT_EQ(styles[1].marking, (MarkingEvidence{MarkingType::solid, MarkingColour::yellow}));
  EXPECT_NEAR(styles[1].from, 30, 1e-9);
  EXPECT_EQ(styles[0].width, 0.3);
}

TEST(OpenDriveLanes, MarksOfLeftLanesChangeFromTheOtherEnd) {
  const std::string marks = mark(0, "broken") + mark(30, "solid");
  const RoadMap map = read(opendrive(road(1, 100, straight(100), section(0, "", lane(1, width(3) + marks)))));
  const std::vector<MarkingStyle>& styles = map.boundaries[1].styles;
  ASSERT_EQ(styles.size(), 2);
  EXPECT_EQ(styles[0].marking.type, MarkingType::solid);
  EXPECT_EQ(styles[1].marking.type, MarkingType::dashed);
  EXPECT_NEAR(styles[1].from, 70, 1e-9);
}

/// Sections at 0, 40 and 80 m; an entry lane in the middle one.
std::string entry_road() {
  const std::string through = "<predecessor id=\"-1\"/><successor id=\"-1\"/>";
  return road(1, 120, straight(120),
              section(0, linked_lane(-1, "<successor id=\"-1\"/>")) +
                  section(40, linked_lane(-1, through) + lane(-2, width(3.5), "entry")) +
                  section(80, linked_lane(-1, "<predecessor id=\"-1\"/>")));
}

TEST(OpenDriveLanes, SectionsMakeOneLane) {
  const RoadMap map = read(opendrive(entry_road()));
  ASSERT_EQ(map.lanes.size(), 2);
  ASSERT_EQ(map.boundaries.size(), 3);
  EXPECT_NEAR(arc_length(map.boundaries[0].points), 120, 1e-9);
  EXPECT_NEAR(arc_length(map.boundaries[1].points), 120, 1e-9);
  EXPECT_NEAR(arc_length(map.boundaries[2].points), 40, 1e-9);
  EXPECT_EQ(map.lanes[1].kind, LaneKind::entry);
  EXPECT_EQ(map.lanes[0].right_lane, map.lanes[1].id);
  EXPECT_EQ(map.lanes[1].left_boundary, map.lanes[0].right_boundary);
}

/// The second road is drawn against the driving direction, so its lane is a left one.
TEST(OpenDriveLanes, RoadsThatMeetEndToEndMakeOneLane) {
  const std::string first = road(1, 100, straight(100), section(0, linked_lane(-1, "<successor id=\"1\"/>")),
                                 "<successor elementType=\"road\" elementId=\"2\" contactPoint=\"end\"/>");
  const std::string second = road(2, 50, straight(50, "x=\"150\" y=\"0\" hdg=\"3.141592653589793\""),
                                  section(0, "", linked_lane(1, "<successor id=\"-1\"/>")),
                                  "<successor elementType=\"road\" elementId=\"1\" contactPoint=\"end\"/>");
  const RoadMap map = read(opendrive(first + second));
  ASSERT_EQ(map.lanes.size(), 1);
  EXPECT_NEAR(arc_length(map.boundaries[0].points), 150, 1e-6);
  EXPECT_NEAR(map.boundaries[1].points.back().y(), -3.5, 1e-6);
}

/// Road 1 leads into a junction: straight on over road 2, to the right over road 3.
std::string junction_map() {
  const std::string into = "<successor elementType=\"junction\" elementId=\"9\"/>";
  const std::string connection =
      "<connection id=\"{}\" incomingRoad=\"1\" connectingRoad=\"{}\" contactPoint=\"start\">"
      "<laneLink from=\"-1\" to=\"-1\"/></connection>\n";
  return road(1, 100, straight(100), section(0, linked_lane(-1, "")), into) +
         road(2, 50, straight(50, "x=\"100\" y=\"0\" hdg=\"0\""), section(0, linked_lane(-1, ""))) +
         road(3, 50, geometry("<arc curvature=\"-0.02\"/>", 50, "x=\"100\" y=\"0\" hdg=\"0\""),
              section(0, linked_lane(-1, ""))) +
         "<junction id=\"9\" name=\"\">\n" + fmt::format(fmt::runtime(connection), 0, 2) +
         fmt::format(fmt::runtime(connection), 1, 3) + "</junction>\n";
}

TEST(OpenDriveLanes, JunctionsLeadOn) {
  const RoadMap map = read(opendrive(junction_map()));
  ASSERT_EQ(map.lanes.size(), 2);  // straight on is the same lane
  EXPECT_NEAR(arc_length(map.boundaries[0].points), 150, 1e-6);
  const MapLane* turn = find_lane(map, 3);
  ASSERT_NE(turn, nullptr);
  EXPECT_EQ(turn->left_lane, std::nullopt);
}

class Refusals : public ::testing::Test {
 protected:
  static void expect_refused(const std::string& text, const std::string& where, const std::string& what) {
    EXPECT_THAT([&] { read(text); },
                ThrowsMessage<Error>(AllOf(HasSubstr("map.xodr, line " + where), HasSubstr(what))));
  }
};

TEST_F(Refusals, NameLineAndElement) {
  const std::string text = opendrive(junction_map());
  expect_refused(replaced(text, "elementId=\"9\"", "elementId=\"8\""), "5, <road id=1>/<link>/<successor>",
                 "refers to junction '8', which is not there");
  expect_refused(replaced(text, "connectingRoad=\"2\"", "connectingRoad=\"7\""), "71, <connection id=0>",
                 "refers to road '7', which is not there");
  expect_refused(replaced(text, "to=\"-1\"", "to=\"-3\""), "71, <connection id=0>/<laneLink>",
                 "refers to lane -3 of road '2'");
  expect_refused(replaced(text, "<road id=\"2\"", "<road id=\"1\""), "26, <road id=1>",
                 "the id of another road");
  expect_refused(replaced(text, "<line/>", "<bezier/>"), "7, <road id=1>/<planView>/<geometry>",
                 "is none of line");
  expect_refused(replaced(text, "<geometry s=\"0\"", "<geometry s=\"-5\""),
                 "7, <road id=1>/<planView>/<geometry>", "attribute 's' is -5");
  expect_refused(replaced(text, "length=\"100\"", "length=\"200\""), "6, <road id=1>/<planView>",
                 "give the road the length of its geometries");
  expect_refused(replaced(text, "length=\"100\"", "length=\"1e9\""), "4, <road id=1>", "attribute 'length'");
  expect_refused(replaced(text, "a=\"3.5\"", "a=\"wide\""), "20, <lane id=-1>/<width>", "no finite number");
  expect_refused(replaced(text, "<lane id=\"-1\"", "<lane id=\"-2\""), "18, <lane id=-2>",
                 "no lane -1 between");
  expect_refused(replaced(text, "<lane id=\"-1\"", "<lane id=\"1\""), "18, <lane id=1>", "none for <right>");
  expect_refused(replaced(text, "curvature=\"-0.02\"", "curvature=\"1e6\""),
                 "52, <road id=3>/<planView>/<geometry>/<arc>", "'curvature'");
  expect_refused(replaced(text, "contactPoint=\"start\"", "contactPoint=\"middle\""), "71, <connection id=0>",
                 "'contactPoint'");
}

TEST_F(Refusals, NameRoadMarks) {
  const std::string text =
      opendrive(road(1, 100, straight(100), section(0, lane(-1, width(3.5) + mark(0, "broken")))));
  expect_refused(replaced(text, "broken", "wavy"), "20, <lane id=-1>/<roadMark>",
                 "'wavy' is no type of road mark");
}

TEST_F(Refusals, LanesOfTooManyPoints) {
  std::string lanes;
  for (int id = 1; id <= 20; ++id) lanes += lane(-id, width(3));
  expect_refused(opendrive(road(1, 500'000, straight(500'000), section(0, lanes))),
                 "12, <road id=1>/<lanes>/<laneSection>", "more than 2000000 points");
}

TEST(OpenDriveLanes, DamageNeverCrashes) {
  const std::string reference = "<geoReference>+proj=tmerc +lat_0=48 +lon_0=11</geoReference>";
  for (const std::string& content : {junction_map(), entry_road()}) {
    survive_damage("map.xodr", opendrive(content, reference),
                   [](const std::filesystem::path& path) { check(read_opendrive(path), "damaged"); });
  }
}

}  // namespace
}  // namespace lanefuse
