// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "evaluation/lane_roles.hpp"
#include "evaluation/true_road_view.hpp"
#include "simulation/road_as_map.hpp"
#include "simulation/varied_road.hpp"

namespace lanefuse {
namespace {

using testing::VariedRoad;

/// How the truth, made of polylines, and the road, made of formulas, may differ [m].
constexpr double kAlike = 0.05;

/// Drives along one lane of a road on which lanes begin, end, widen and shift, and holds the roles to what
/// the road itself says of its neighbours.
class RolesAlong {
 public:
  explicit RolesAlong(int lane) : lane_(lane), view_(truth_), lanes_(truth_) {}

  void check(double station) {
    const Pose2 world_from_car = road_.pose(station, road_.lane_centre(lane_, station));
    const TrueRoles roles = lanes_.roles(view_.look_from(world_from_car));
    expect_line(roles[kEgoLeft], road_.left_line(lane_), station);
    expect_line(roles[kEgoRight], road_.right_line(lane_), station);
    expect_neighbour(roles[kAdjacentLeft], Side::left, station);
    expect_neighbour(roles[kAdjacentRight], Side::right, station);
  }

 private:
  void expect_line(const RoleLine& role, int line, double station) const {
    const double offset = road_.line_lateral(line, station) - road_.lane_centre(lane_, station);
    ASSERT_TRUE(role.y(0)) << "line " << line << " at " << station;
    EXPECT_NEAR(*role.y(0), offset, kAlike) << "line " << line << " at " << station;
  }

  void expect_neighbour(const RoleLine& role, Side side, double station) const {
    const auto lane = road_.neighbour(lane_, side, station);
    if (lane) {
      expect_line(role, side == Side::left ? road_.left_line(*lane) : road_.right_line(*lane), station);
    } else if (role.y(0)) {
      EXPECT_LT(narrowest_beside(side, station), kDrivableWidth) << station;
    }
  }

  /// The width of the lane that is there, but is too narrow for the simulator's vehicles to choose.
  [[nodiscard]] double narrowest_beside(Side side, double station) const {
    double narrowest = 1e9;
    for (int other = 0; other < road_.lane_count(); ++other) {
      const bool beside = side == Side::left ? road_.right_line(other) == road_.left_line(lane_)
                                             : road_.left_line(other) == road_.right_line(lane_);
      if (beside && road_.lane_exists(other, station))
        narrowest = std::min(narrowest, road_.lane_width(other, station));
    }
    return narrowest;
  }

  int lane_;
  Road road_ = VariedRoad::make(1);
  TrueRoad truth_ = true_road(road_);
  TrueRoadView view_;
  TrueLanes lanes_;
};

TEST(TrueLanes, AgreeWithTheSimulatedRoadWhereverLanesBeginAndEnd) {
  for (const int lane : {1, 2, 3}) {
    RolesAlong along(lane);
    for (double station = 50; station < 5400; station += 7) along.check(station);
  }
}

TEST(TrueLanes, SeeASimulatedLaneEndAhead) {
  const Road road = VariedRoad::make(1);
  const TrueRoad truth = true_road(road);
  TrueRoadView view(truth);
  const double station = VariedRoad::kEndingLaneEnd - 100;
  const TrueRoles roles = TrueLanes(truth).roles(
      view.look_from(road.pose(station, road.lane_centre(VariedRoad::kEndingLane, station))));
  EXPECT_TRUE(roles[kEgoLeft].y(90));
  EXPECT_FALSE(roles[kEgoLeft].y(110));
  EXPECT_TRUE(roles[kEgoRight].y(120));  // the line itself goes on
  EXPECT_TRUE(roles[kAdjacentRight].y(120));
}

}  // namespace
}  // namespace lanefuse
