// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive.hpp"

#include <array>
#include <cmath>

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
using testing::distance_beside;
using testing::expect_same_lanes;
using testing::expect_same_styles;
using ::testing::HasSubstr;
using testing::replaced;
using testing::ScratchMap;
using testing::survive_damage;
using ::testing::ThrowsMessage;

TEST(OpenDrive, ReadsTheE6) {
  const auto path = testing::real_data("opendrive/e6mini.xodr");
  LANEFUSE_NEEDS_DATA(path);
  const RoadMap map = read_opendrive(path);
  ASSERT_EQ(map.lanes.size(), 8);  // three lanes and a hard shoulder each way
  ASSERT_EQ(map.boundaries.size(), 10);
  EXPECT_NEAR(map.origin.value().latitude_deg, 37.35429341239328, 1e-12);
  for (const std::size_t carriageway : {0, 4}) {
    const MapLane& left = map.lanes[carriageway];
    EXPECT_EQ(left.left_lane, std::nullopt);  // oncoming lanes are no neighbours
    EXPECT_EQ(map.lanes[carriageway + 3].kind, LaneKind::emergency);
    const std::array widths = {3.65, 3.5, 3.9, 2.85};
    for (std::size_t i = 0; i < 4; ++i) {
      const MapLane& lane = map.lanes[carriageway + i];
      const MapBoundary& right = *find_boundary(map, lane.right_boundary);
      for (const Eigen::Vector3d& point : find_boundary(map, lane.left_boundary)->points) {
        const auto width = distance_beside(right, point);
        if (width) {
          EXPECT_NEAR(*width, widths[i], 0.005);
        }
      }
    }
  }
  EXPECT_NEAR(arc_length(map.boundaries[5].points), 1464.4, 3);
  const std::array types = {MarkingType::solid, MarkingType::dashed, MarkingType::dashed, MarkingType::solid};
  const std::array paint = {0.3, 0.15, 0.15, 0.3};
  for (std::size_t i = 0; i < types.size(); ++i) {
    EXPECT_EQ(map.boundaries[i].styles[0].marking.type, types[i]);
    EXPECT_EQ(map.boundaries[5 + i].styles[0].marking.type, types[i]);
    EXPECT_EQ(map.boundaries[i].styles[0].marking.colour, MarkingColour::white);
    EXPECT_EQ(map.boundaries[i].styles[0].width, paint[i]);
  }
  const Eigen::Vector3d there = map.boundaries[5].points.back() - map.boundaries[5].points.front();
  const Eigen::Vector3d back = map.boundaries[0].points.back() - map.boundaries[0].points.front();
  EXPECT_GT(there.y(), 1400);  // the road runs north, left lanes are driven south
  EXPECT_LT(back.y(), -1400);
}

RoadMap round_trip(const RoadMap& map, const ExactPlan* plan = nullptr) {
  const ScratchMap file("map.xodr", opendrive_text(map, plan));
  return read_opendrive(file.path());
}

TEST(OpenDrive, TheE6SurvivesWriting) {
  const auto path = testing::real_data("opendrive/e6mini.xodr");
  LANEFUSE_NEEDS_DATA(path);
  const RoadMap map = read_opendrive(path);
  const RoadMap again = round_trip(map);
  expect_same_lanes(map, again, 0.01);
  EXPECT_EQ(again.origin, map.origin);
}

TEST(OpenDrive, RealLaneletsSurviveWriting) {
  for (const char* name :
       {"DEU_A99-1_1", "DEU_A9-2_1", "USA_US101-11_4", "USA_US101-15_1", "USA_US101-24_2"}) {
    SCOPED_TRACE(name);
    const auto path = testing::real_data("commonroad") / (std::string(name) + "_T-1.xml");
    LANEFUSE_NEEDS_DATA(path);
    const RoadMap map = read_commonroad(path).map;
    const RoadMap again = round_trip(map);
    expect_same_lanes(map, again, 0.01);
    EXPECT_EQ(again.name, map.name);
  }
}

}  // namespace
}  // namespace lanefuse
