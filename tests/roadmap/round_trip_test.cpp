// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "roadmap/geojson.hpp"
#include "roadmap/lanelet2.hpp"
#include "roadmap/map_files.hpp"
#include "roadmap/opendrive.hpp"
#include "support/map_comparison.hpp"
#include "support/map_files.hpp"
#include "support/random_motorway.hpp"

namespace lanefuse {
namespace {

using testing::any_motorway;
using testing::expect_same_lanes;
using testing::expect_same_styles;
using ::testing::HasSubstr;
using testing::RandomMotorway;
using testing::ScratchMap;
using ::testing::ThrowsMessage;

/// The same lanes, neighbours, kinds, paint, and the same origin.
void expect_same_map(const RoadMap& map, const RoadMap& again, double tolerance) {
  expect_same_lanes(map, again, tolerance);
  const auto lanes = testing::matched_lanes(map, again, tolerance);
  for (const MapLane& lane : map.lanes) {
    const MapLane* other = find_lane(again, lanes.at(lane.id));
    for (const auto side : {&MapLane::left_boundary, &MapLane::right_boundary}) {
      expect_same_styles(*find_boundary(map, lane.*side), *find_boundary(again, other->*side));
    }
  }
  ASSERT_TRUE(again.origin.has_value());
  EXPECT_NEAR(again.origin->latitude_deg, map.origin->latitude_deg, 1e-10);
  EXPECT_NEAR(again.origin->longitude_deg, map.origin->longitude_deg, 1e-10);
  EXPECT_NEAR(again.origin->height, map.origin->height, 1e-9);
}

RoadMap read_back(const std::string& name, const std::string& text) {
  const ScratchMap file(name, text);
  return read_map(file.path());
}

RC_GTEST_PROP(RoundTrip, OpenDriveAlongASmoothLine, ()) {
  const RoadMap map = any_motorway().map;
  expect_same_map(map, read_back("map.xodr", opendrive_text(map)), 0.01);
  RC_ASSERT(!::testing::Test::HasFailure());
}

TEST(RoundTrip, OpenDriveOfALineThatBeginsWithARepeatedPoint) {
  RoadMap map{
      "test", {}, {{1, {{0, 2, 0}, {0, 2, 0}, {99, 2, 0}}, {{}}}, {2, {{0, -2, 0}, {99, -2, 0}}, {{}}}}, {}};
  map.lanes = {{1, LaneKind::driving, 1, 2, {}, {}, {}}};
  EXPECT_THAT(opendrive_text(map), ::testing::Not(HasSubstr("nan")));
}

RC_GTEST_PROP(RoundTrip, OpenDriveAlongTheExactLine, ()) {
  const RandomMotorway road = any_motorway();
  const std::string text = opendrive_text(road.map, &road.plan);
  RC_ASSERT(text.find("<spiral") != std::string::npos || road.plan.pieces[0].curvature_rate == 0);
  RC_ASSERT(text.find("<paramPoly3") == std::string::npos);
  expect_same_map(road.map, read_back("map.xodr", text), 0.01);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(RoundTrip, Lanelet2, ()) {
  const RoadMap map = any_motorway().map;
  expect_same_map(map, read_back("map.osm", lanelet2_text(map)), 0.001);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(RoundTrip, Lanelet2WithoutAnOrigin, ()) {
  RoadMap map = any_motorway().map;
  map.origin.reset();
  const RoadMap again = read_back("map.osm", lanelet2_text(map));
  RC_ASSERT(!again.origin.has_value());
  expect_same_lanes(map, again, 0.001);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(RoundTrip, GeoJson, ()) {
  const RoadMap map = any_motorway().map;
  const RoadMap again = read_back("map.geojson", geojson_text(map));
  expect_same_map(map, again, 0.001);
  RC_ASSERT(again.name == map.name);
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace lanefuse
