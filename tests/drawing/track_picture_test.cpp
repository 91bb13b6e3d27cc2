// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/track_picture.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "drawing/label_places.hpp"
#include "drawing/thinned_line.hpp"
#include "support/markup.hpp"

namespace lanefuse {
namespace {

TrackedObject object(std::int64_t id, double x, double y, MovementState movement, bool witness) {
  TrackedObject made;
  made.id = id;
  made.x = x;
  made.y = y;
  made.movement = movement;
  made.witness = witness;
  return made;
}

/// A leader that bears witness from the fifth second on, a post that is passed, and a short-lived neighbour.
TrackHistory history_of(int cycles) {
  TrackHistory history;
  for (int i = 0; i < cycles; ++i) {
    const double t = 0.08 * i;
    std::vector<TrackedObject> seen{object(7, 40 + t, 0.1, MovementState::moving, t > 5),
                                    object(8, 120 - 10 * t, -9, MovementState::stationary, false)};
    if (t > 3 && t < 4) seen.push_back(object(12, 30, 3.5, MovementState::moving, true));
    history.add(t, seen);
  }
  return history;
}

TEST(TrackHistory, TellsWhoLivedHowLongAndAsWhat) {
  const std::vector<TrackedLife> lives = history_of(101).lives();
  ASSERT_EQ(lives.size(), 3U);
  EXPECT_EQ(lives[0].id, 7);
  EXPECT_NEAR(lives[0].kept(), 8, 1e-9);
  EXPECT_TRUE(lives[0].was(TrackRole::witness));
  EXPECT_TRUE(lives[0].was(TrackRole::driving));
  EXPECT_FALSE(lives[0].was(TrackRole::standing));
  EXPECT_FALSE(lives[1].was(TrackRole::driving));
  EXPECT_EQ(lives[2].id, 12);
}

TEST(TrackHistory, LeavesOutWhatHasNoPlace) {
  TrackHistory history;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  history.add(0, std::vector{object(1, nan, 0, MovementState::moving, false)});
  EXPECT_TRUE(history.lives().empty());
}

TEST(DrawTracks, LabelsIdsWithTheTimeForWhichTheyWereKept) {
  const std::string svg = standalone_svg(draw_tracks("A & B", history_of(101)));
  EXPECT_EQ(testing::malformed(svg), "");
  EXPECT_FALSE(testing::prints_nan(svg));
  EXPECT_TRUE(testing::addresses(svg).empty());
  for (const char* part : {"A &amp; B", "distance ahead [m]", "to the left [m]", ">7: 8 s<", ">7<", ">12<"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
}

TEST(DrawTracks, ShowsWitnessesThickAndWhatStandsGrey) {
  const std::string svg = draw_tracks("a", history_of(101)).elements;
  // Each has a line in either panel; the leader is thin until it bears witness. One sample in the legend.
  EXPECT_EQ(testing::occurrences(svg, "pen-series-3 thin round"), 2);
  EXPECT_EQ(testing::occurrences(svg, "thin round"), 2 + 2);
  EXPECT_EQ(testing::occurrences(svg, "thick round"), 2 + 2);
}

TEST(DrawTracks, GivesThoseThatWereThereTogetherColoursOfTheirOwn) {
  TrackHistory history;
  for (int i = 0; i < 100; ++i) {
    std::vector<TrackedObject> seen;
    for (std::int64_t id = 0; id < 8; ++id) {
      seen.push_back(object(id, 10.0 * static_cast<double>(id), 0, MovementState::moving, true));
    }
    history.add(0.1 * i, seen);
  }
  const std::string svg = draw_tracks("a", history).elements;
  for (const char* colour : {"series-0", "series-1", "series-2", "series-4"}) {
    EXPECT_EQ(testing::occurrences(svg, std::string("pen-") + colour + " thick round"), 2) << colour;
  }
}

TEST(DrawTracks, BreaksWhereNothingWasSaid) {
  TrackHistory history;
  for (const double t : {0.0, 0.1, 0.2, 5.0, 5.1, 5.2}) {
    history.add(t, std::vector{object(1, 10 + t * t, 0, MovementState::moving, false)});
  }
  EXPECT_EQ(testing::occurrences(draw_tracks("a", history).elements, "thin round"), 2 * 2);
}

TEST(DrawTracks, SaysThatThereIsNothing) {
  const std::string svg = standalone_svg(draw_tracks("a", TrackHistory()));
  EXPECT_NE(svg.find("no tracks"), std::string::npos);
  EXPECT_FALSE(testing::prints_nan(svg));
}

TEST(DrawTracks, StaysSmallHoweverManyCycles) {
  EXPECT_LT(draw_tracks("a", history_of(20000)).elements.size(), 40000U);
}

RC_GTEST_PROP(ThinnedLine, StaysWithinItsTolerance, ()) {
  const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-20, 21));
  std::vector<Pixel> line;
  for (std::size_t i = 0; i < steps.size(); ++i) line.emplace_back(2.0 * static_cast<double>(i), steps[i]);
  const std::vector<Pixel> thin = thinned_line(line, 1.5);
  RC_ASSERT(thin.size() <= line.size());
  for (std::size_t i = 0, at = 0; i < line.size(); ++i) {
    if (thin[at] == line[i] && at + 1 < thin.size()) ++at;
    const Pixel& from = thin[at == 0 ? 0 : at - 1];
    const Pixel along = thin[at] - from;
    const double length = std::max(along.squaredNorm(), 1e-12);
    const double share = std::clamp((line[i] - from).dot(along) / length, 0.0, 1.0);
    RC_ASSERT((from + share * along - line[i]).norm() <= 1.5 + 1e-9);
  }
}

TEST(ThinnedLine, NeedsTwoPointsForAStraightOne) {
  std::vector<Pixel> line;
  for (int i = 0; i < 100; ++i) line.emplace_back(i, 3 * i);
  EXPECT_EQ(thinned_line(line, 0.1).size(), 2U);
}

TEST(LabelPlaces, NeverLayOneLabelOnAnother) {
  LabelPlaces places({0, 0, 200, 40});
  const std::vector<Pixel> line{{10, 20}, {100, 20}, {190, 20}};
  std::vector<Box> taken;
  while (const auto place = places.beside(line, "12: 30 s")) {
    EXPECT_GE(place->left, 0);
    EXPECT_LE(place->bottom(), 40);
    for (const Box& other : taken) {
      const bool apart = place->right() <= other.left || other.right() <= place->left ||
                         place->bottom() <= other.top || other.bottom() <= place->top;
      EXPECT_TRUE(apart);
    }
    taken.push_back(*place);
    ASSERT_LT(taken.size(), 10U);
  }
  EXPECT_GE(taken.size(), 4U);
}

}  // namespace
}  // namespace lanefuse
