// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/geojson.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/map_files.hpp"

namespace lanefuse {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::replaced;
using testing::ScratchMap;
using testing::survive_damage;
using ::testing::ThrowsMessage;

/// One lane to the north of the origin, 111 m long, with a change of paint on its left.
RoadMap one_lane() {
  const MarkingStyle dashed{0, {MarkingType::dashed, MarkingColour::white}, 0.15};
  const MarkingStyle solid{40, {MarkingType::solid, MarkingColour::yellow}, 0.3};
  RoadMap map{"one", GeoOrigin{48, 11, 500}, {}, {}};
  map.boundaries = {{1, {{0, 0, 0}, {0, 111, 1}}, {dashed, solid}},
                    {2, {{3.5, 0, 0}, {3.5, 111, 1}}, {dashed}}};
  map.lanes = {{7, LaneKind::exit, 1, 2, {}, {}, {}}};
  return map;
}

RoadMap read(const std::string& text) {
  const ScratchMap file("map.geojson", text);
  return read_geojson(file.path());
}

TEST(GeoJson, PutsLongitudeFirst) {
  const std::string text = geojson_text(one_lane());
  const std::size_t line = text.find("LineString");
  const std::size_t longitude = text.find("11.0", line);
  const std::size_t latitude = text.find("48.0", line);
  ASSERT_NE(longitude, std::string::npos);
  EXPECT_LT(longitude, latitude);
  EXPECT_NE(text.find("48.00099"), std::string::npos);  // 111 m are 0.000998 deg
}

TEST(GeoJson, IsReadAsItWasWritten) {
  const RoadMap map = one_lane();
  const RoadMap again = read(geojson_text(map));
  ASSERT_EQ(again.boundaries.size(), 2);
  EXPECT_EQ(again.boundaries[0].styles, map.boundaries[0].styles);
  EXPECT_NEAR((again.boundaries[1].points[1] - map.boundaries[1].points[1]).norm(), 0, 1e-6);
  ASSERT_EQ(again.lanes.size(), 1);
  EXPECT_EQ(again.lanes[0].id, 7);
  EXPECT_EQ(again.lanes[0].kind, LaneKind::exit);
  EXPECT_EQ(again.origin, map.origin);
}

TEST(GeoJson, NeedsAnOrigin) {
  RoadMap map = one_lane();
  map.origin.reset();
  EXPECT_THAT([&] { geojson_text(map); }, ThrowsMessage<Error>(HasSubstr("--origin LAT,LON adds it")));
}

void expect_refused(const std::string& from, const std::string& to, const std::string& what) {
  EXPECT_THAT([&] { read(replaced(geojson_text(one_lane()), from, to)); },
              ThrowsMessage<Error>(AllOf(HasSubstr("map.geojson"), HasSubstr(what))));
}

TEST(GeoJson, RefusalsNameTheFeature) {
  expect_refused("\"dashed\"", "\"wavy\"", ".features[0].properties.styles[0].type: is 'wavy'");
  expect_refused("\"width\": 0.15", "\"width\": -1", ".features[0].properties.styles[0].width: is no number");
  expect_refused("\"id\": 7", "\"id\": -7", ".features[2].properties.id: is no id");
  expect_refused("\"left_boundary\": 1", "\"left_boundary\": 9", "lane 7: refers to boundary 9");
  expect_refused("\"LineString\"", "\"Point\"", ".features[0].geometry: is no LineString");
  expect_refused("\"origin\"", "\"origyn\"", "has no 'origin'");
  expect_refused("\"features\": [", "\"features\": ", "is no sound JSON");
  expect_refused("\"FeatureCollection\"", "4", ".type: is no text");
  expect_refused("\"successors\": []", "\"successors\": {}",
                 ".features[2].properties.successors: is no list");
}

TEST(GeoJson, DeepNestingIsRefused) {
  EXPECT_THAT([&] { read(std::string(1000, '[') + std::string(1000, ']')); },
              ThrowsMessage<Error>(HasSubstr("nested deeper than 64")));
}

TEST(GeoJson, DamageNeverCrashes) {
  survive_damage("map.geojson", geojson_text(one_lane()),
                 [](const std::filesystem::path& path) { check(read_geojson(path), "damaged"); });
}

}  // namespace
}  // namespace lanefuse
