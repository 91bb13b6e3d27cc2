// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/true_road_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

/// 4 km of a winding road with one boundary that is there only between 1 km and 1.5 km.
struct WindingRoad {
  static Pose2 pose(double along) {
    return {along, 60 * std::sin(along / 400), std::atan(0.15 * std::cos(along / 400))};
  }

  static TrueRoad road() {
    TrueRoad road;
    for (const auto& [offset, from, to] : {std::tuple{1.8, 0, 4000}, {-1.8, 0, 4000}, {-5.4, 1000, 1500}}) {
      TrueBoundary boundary;
      for (int along = from; along < to; along += 2)
        boundary.points.push_back(pose(along) * Eigen::Vector2d(0, offset));
      road.boundaries.push_back(boundary);
    }
    return road;
  }
};

TEST(TrueRoadView, SeesTheSameHoweverTheCarCameThere) {
  const TrueRoad road = WindingRoad::road();
  TrueRoadView moving(road);
  for (const double along : {10.0, 30.0, 200.0, 205.0, 800.0, 960.0, 1000.0, 1400.0, 1440.0, 1480.0, 1520.0,
                             300.0, 290.0, 3990.0}) {
    const auto& seen = moving.look_from(WindingRoad::pose(along));
    TrueRoadView fresh(road);
    const auto& expected = fresh.look_from(WindingRoad::pose(along));
    for (std::size_t i = 0; i < road.boundaries.size(); ++i)
      EXPECT_EQ(seen[i].points(), expected[i].points()) << along;
  }
}

TEST(TrueRoadView, ReachesFromBehindTheCarToFarAhead) {
  const TrueRoad road = WindingRoad::road();
  TrueRoadView view(road);
  const auto& lines = view.look_from(WindingRoad::pose(500));
  EXPECT_LE(lines[0].points().front().x(), -TrueRoadView::kViewBehind);
  EXPECT_GE(lines[0].points().back().x(), TrueRoadView::kViewAhead);
  EXPECT_NEAR(*lines[0].y(0), 1.8, 0.01);
  EXPECT_NEAR(*lines[1].y(0), -1.8, 0.01);
}

TEST(TrueRoadView, SeesNothingOfABoundaryThatIsNotHere) {
  const TrueRoad road = WindingRoad::road();
  TrueRoadView view(road);
  EXPECT_FALSE(view.look_from(WindingRoad::pose(500))[2].y(0));
  EXPECT_FALSE(view.look_from(WindingRoad::pose(500))[2].y(120));
  EXPECT_FALSE(view.look_from(WindingRoad::pose(950))[2].y(0));
  EXPECT_TRUE(view.look_from(WindingRoad::pose(950))[2].y(120));
  EXPECT_TRUE(view.look_from(WindingRoad::pose(1450))[2].y(0));
  EXPECT_FALSE(view.look_from(WindingRoad::pose(1450))[2].y(120));
  EXPECT_FALSE(view.look_from(WindingRoad::pose(2500))[2].y(0));
}

TEST(TrueRoadView, EndsWhereTheRoadTurnsBack) {
  TrueRoad road;
  road.boundaries.resize(1);
  for (int degree = 0; degree < 360; ++degree) {
    const double angle = degree * 0.017453292519943295;
    road.boundaries[0].points.emplace_back(50 * std::sin(angle), 50 * (1 - std::cos(angle)));
  }
  TrueRoadView view(road);
  const LineAhead& line = view.look_from({0, 0, 0})[0];
  EXPECT_NEAR(line.points().back().x(), 50, 0.01);
}

TEST(TrueRoadView, AnEmptyRoadIsSeenAsEmpty) {
  const TrueRoad nothing;
  TrueRoadView view(nothing);
  EXPECT_TRUE(view.look_from({}).empty());
  TrueRoad pointless;
  pointless.boundaries.resize(1);
  TrueRoadView pointless_view(pointless);
  EXPECT_FALSE(pointless_view.look_from({})[0].y(0));
}

TEST(TrueRoadView, FindsABoundaryAgainThatComesIntoSightElsewhere) {
  // A ramp: from the car's start it is nearest at its begin, and it comes back to the road 3 km on.
  TrueRoad road = WindingRoad::road();
  TrueBoundary ramp;
  for (int along = 0; along < 4000; along += 2) {
    const double away = 900 * std::pow(std::sin(along / 3000.0 * 3.14159), 2);
    ramp.points.push_back(WindingRoad::pose(along) * Eigen::Vector2d(0, -5.4 - away));
  }
  // The way back on the other side of the road lies between, so that creeping along the ramp gets stuck.
  for (std::size_t i = 600; i < 900; ++i) ramp.points[i].x() -= 700;
  road.boundaries.push_back(ramp);
  TrueRoadView moving(road);
  for (double along = 0; along < 3300; along += 2.4) moving.look_from(WindingRoad::pose(along));
  EXPECT_TRUE(moving.lines()[3].y(0));
}

}  // namespace
}  // namespace lanefuse
