// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "simulation/generated_road.hpp"
#include "simulation/road_as_map.hpp"

namespace lanefuse {
namespace {

using Kind = RoadEvent::Kind;

constexpr double kStart = 400;

Road road_with(const std::vector<RoadEvent>& events, std::uint64_t seed = 1) {
  return generated_road({RoadKind::gentle, 4000, kStart, events}, nominal_preset().road, seed);
}

RoadEvent event(Kind kind, double first, double every = 0, double length = 0) {
  RoadEvent event;
  event.kind = kind;
  event.first = first;
  event.every = every;
  event.length = length;
  return event;
}

int lanes_at(const Road& road, double station) {
  int lanes = 0;
  for (int lane = 0; lane < road.lane_count(); ++lane) lanes += road.lane_exists(lane, station);
  return lanes;
}

TEST(RoadEvents, LinesNeverJumpAndLanesNeverTurnInsideOut) {
  const Road road = road_with({event(Kind::exit, 300), event(Kind::entry, 900), event(Kind::lane_drop, 1500),
                               event(Kind::construction, 2400)});
  for (double station = 0; station < road.length() - 1; station += 0.5) {
    for (int line = 0; line < road.line_count(); ++line) {
      const double step = road.line_lateral(line, station + 0.5) - road.line_lateral(line, station);
      ASSERT_LT(std::abs(step), 0.1) << "line " << line << " at " << station;
      ASSERT_NEAR(step, 0.5 * road.line_slope(line, station + 0.25), 2e-3);
    }
    for (int lane = 0; lane < road.lane_count(); ++lane) {
      if (!road.lane_exists(lane, station)) continue;
      ASSERT_GE(road.lane_width(lane, station), -1e-9) << "lane " << lane << " at " << station;
    }
  }
}

TEST(RoadEvents, AnExitOpensBesideTheRightLaneAndLeaves) {
  const Road road = road_with({event(Kind::exit, 300, 2000)});
  EXPECT_EQ(lanes_at(road, 690), 3);
  EXPECT_EQ(lanes_at(road, 800), 4);
  EXPECT_EQ(lanes_at(road, 1150), 3);
  EXPECT_EQ(lanes_at(road, 2800), 4);  // and again
  const std::optional<int> exit = road.neighbour(2, Side::right, 850);
  ASSERT_TRUE(exit);
  EXPECT_EQ(road.lane_kind(*exit), LaneKind::exit);
  EXPECT_EQ(road.neighbour(*exit, Side::left, 850), 2);
  EXPECT_FALSE(road.neighbour(2, Side::right, 702)) << "too narrow yet";
  EXPECT_EQ(road.lane_at(850, road.lane_centre(*exit, 850)), exit);
  EXPECT_EQ(road.marking(3, 850).type, MarkingType::dashed);
  EXPECT_EQ(road.marking(3, 1000).type, MarkingType::solid);
  const RoadMap map = road_map(road);
  check(map, "the road");
  const MapLane* lane = find_lane(map, static_cast<std::uint64_t>(*exit) + 1);
  ASSERT_EQ(lane->successors.size(), 1u);
  EXPECT_EQ(find_lane(map, lane->successors.front())->kind, LaneKind::exit);
}

TEST(RoadEvents, AnEntryJoinsAndEnds) {
  const Road road = road_with({event(Kind::entry, 300)});
  EXPECT_EQ(lanes_at(road, 900), 4);
  EXPECT_EQ(lanes_at(road, 1101), 3);
  const std::optional<int> entry = road.neighbour(2, Side::right, 900);
  ASSERT_TRUE(entry);
  EXPECT_EQ(road.lane_kind(*entry), LaneKind::entry);
  EXPECT_DOUBLE_EQ(road.lane_end(*entry), 1100);
  EXPECT_NEAR(road.lane_width(*entry, 1100), 0, 1e-9);
}

TEST(RoadEvents, FourLanesBecomeThree) {
  const Road road = road_with({event(Kind::lane_drop, 300, 0, 800)});
  EXPECT_EQ(lanes_at(road, 1000), 4);
  EXPECT_EQ(lanes_at(road, 1501), 3);
  EXPECT_EQ(road.lane_kind(3), LaneKind::driving);
  EXPECT_TRUE(road.painted(3, 1501));
  EXPECT_LT(road.guard_rail(-1, 1000), road.guard_rail(-1, 300) - 3);
}

TEST(RoadEvents, AConstructionZoneIsYellowAndNarrowOverWhiteGhosts) {
  const Road road = road_with({event(Kind::construction, 300, 0, 1000)});
  EXPECT_EQ(road.marking(1, 600).colour, MarkingColour::white);
  EXPECT_EQ(road.marking(1, 1000).colour, MarkingColour::yellow);
  EXPECT_EQ(road.marking(1, 1701).colour, MarkingColour::white);
  EXPECT_NEAR(road.lane_width(0, 1000), 2.85, 1e-9);
  EXPECT_NEAR(road.lane_width(2, 1000), 3.25, 1e-9);
  EXPECT_GT(std::abs(road.line_lateral(0, 1000) - road.line_lateral(0, 500)), 0.5);
  int ghosts = 0;
  for (int line = 0; line < road.line_count(); ++line) {
    if (!road.parts().lines[static_cast<std::size_t>(line)].ghost) continue;
    ++ghosts;
    EXPECT_EQ(road.marking(line, 1000).colour, MarkingColour::white);
    EXPECT_FALSE(road.painted(line, 1701));
  }
  EXPECT_EQ(ghosts, 4);
  EXPECT_EQ(true_road(road).boundaries.size(), 4u) << "ghosts bound nothing";
}

TEST(RoadEvents, PaintIsMissingOnItsShareOfTheRoad) {
  RoadEvent missing = event(Kind::missing_paint, 0);
  missing.share = 0.4;
  double bare = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Road road = road_with({missing}, seed);
    for (double station = kStart; station < 4000; station += 1) {
      all += 1;
      bare += !road.painted(0, station);
      ASSERT_EQ(road.painted(0, station), road.painted(3, station));
    }
  }
  EXPECT_NEAR(bare / all, 0.4, 0.05);
}

TEST(RoadEvents, PaintCanBeMissingRightOfTheEgoLane) {
  RoadEvent missing = event(Kind::missing_paint, 300);
  missing.lines = RoadEvent::Lines::right_of_ego;
  const Road road = road_with({missing});
  double left = 0, right = 0;
  for (double station = 700; station < 4000; station += 1) {
    left += road.painted(1, station);
    right += road.painted(2, station) + road.painted(3, station);
  }
  EXPECT_GT(left, 1000);
  EXPECT_EQ(right, 0);
  EXPECT_TRUE(road.painted(3, 690));
}

TEST(RoadEvents, RefusesEventsThatOverlap) {
  EXPECT_THROW(road_with({event(Kind::exit, 300), event(Kind::construction, 500)}), Error);
  EXPECT_THROW(road_with({event(Kind::exit, 300, 350)}), Error);
}

TEST(RoadEvents, LeaveTheRoadItselfAlone) {
  const Road plain = road_with({});
  const Road road = road_with({event(Kind::exit, 300)});
  EXPECT_EQ(plain.pose(2000, 1).x, road.pose(2000, 1).x);
  EXPECT_EQ(plain.line_lateral(1, 850), road.line_lateral(1, 850));
}

}  // namespace
}  // namespace lanefuse
