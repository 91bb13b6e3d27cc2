// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/road_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

MapBoundary line(std::uint64_t id, double y) {
  const MarkingStyle white{0, {MarkingType::dashed, MarkingColour::white}, 0.15};
  return {id, {{0, y, 0}, {100, y, 0}}, {white}};
}

/// Two driving lanes and the emergency lane to their right.
RoadMap motorway() {
  RoadMap map{"test", {}, {line(1, 3.5), line(2, 0), line(3, -3.5), line(4, -6)}, {}};
  map.lanes = {{1, LaneKind::driving, 1, 2, {}, 2, {}},
               {2, LaneKind::driving, 2, 3, 1, 3, {}},
               {3, LaneKind::emergency, 3, 4, 2, {}, {}}};
  return map;
}

void expect_refused(const RoadMap& map, const std::string& what) {
  EXPECT_THAT([&] { check(map, "a.xodr"); }, ThrowsMessage<Error>(HasSubstr(what)));
}

TEST(RoadMap, SoundMapPasses) { EXPECT_NO_THROW(check(motorway(), "a.xodr")); }

TEST(RoadMap, WhatIsWrongIsNamed) {
  RoadMap map = motorway();
  map.lanes[1].right_boundary = 9;
  expect_refused(map, "a.xodr, lane 2: refers to boundary 9");
  map = motorway();
  map.boundaries[2].id = 2;
  expect_refused(map, "boundary 2 is there twice");
  map = motorway();
  map.boundaries[0].points.resize(1);
  expect_refused(map, "boundary 1: has fewer than two points");
  map = motorway();
  map.boundaries[0].points[1].y() = std::numeric_limits<double>::quiet_NaN();
  expect_refused(map, "not finite");
  map = motorway();
  map.lanes[0].successors = {7};
  expect_refused(map, "lane 1: refers to lane 7");
  map = motorway();
  map.boundaries[2].points[1] = map.boundaries[2].points[0];
  expect_refused(map, "boundary 3: has no length");
  map = motorway();
  map.boundaries[2].points[1].x() = 1e9;
  expect_refused(map, "boundary 3: brings the boundaries to more than 20000 km");
}

TEST(RoadMap, StyleHoldsFromItsPlaceOn) {
  MapBoundary boundary = line(1, 0);
  boundary.styles.push_back({40, {MarkingType::solid, MarkingColour::yellow}, 0.3});
  EXPECT_EQ(style_at(boundary, 39.9).marking.type, MarkingType::dashed);
  EXPECT_EQ(style_at(boundary, 40).marking.type, MarkingType::solid);
  EXPECT_EQ(style_at(boundary, 1000).marking.type, MarkingType::solid);
}

TEST(RoadMap, AsTruthItHasNoEmergencyLane) {
  const TrueRoad road = true_road(motorway());
  ASSERT_EQ(road.boundaries.size(), 4);
  ASSERT_EQ(road.lanes.size(), 2);
  EXPECT_EQ(road.lanes[0].right_lane, 2);
  EXPECT_EQ(road.lanes[1].right_lane, std::nullopt);
}

TEST(RoadMap, AsTruthABoundaryHasTheStyleThatPrevails) {
  RoadMap map = motorway();
  map.boundaries[1].styles.push_back({40, {MarkingType::solid, MarkingColour::white}, 0.3});
  EXPECT_EQ(true_road(map).boundaries[1].marking.type, MarkingType::solid);
}

}  // namespace
}  // namespace lanefuse
