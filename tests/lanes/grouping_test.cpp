// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/grouping.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lanes/marking_features.hpp"

namespace lanefuse {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Clothoid kBend{0, 0.02, 1e-3, 0};

class Sorting : public ::testing::Test {
 protected:
  /// Features at these offsets from the bend, 2 m from each other along it.
  void put(const std::vector<double>& offsets, double from = 10, double confidence = 0.8) {
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const double x = from + 2 * static_cast<double>(i);
      features_.push_back({x, kBend.y(x) + offsets[i], kBend.heading_at(x), confidence});
    }
    roles_.assign(features_.size(), FitRole::inlier);
  }
  std::vector<int> groups(const std::vector<double>& offsets) {
    grouping_.assign(features_, roles_, kBend, offsets);
    return {grouping_.groups().begin(), grouping_.groups().end()};
  }
  std::vector<double> founded(const std::vector<double>& offsets = {}) {
    groups(offsets);
    const auto founded = grouping_.new_offsets(features_, kBend, offsets);
    return {founded.begin(), founded.end()};
  }

  LaneModelConfig config_;
  Grouping grouping_{config_};
  std::vector<Feature> features_;
  std::vector<FitRole> roles_;
};

TEST_F(Sorting, GivesAFeatureToTheNearestOffsetAlongTheBend) {
  put({1.7, -1.9, 5.0, 3.4, 3.6}, 60);
  EXPECT_THAT(groups({5.2, 1.8, -1.8}), ElementsAre(1, 2, 0, -1, -1));
  EXPECT_THAT(groups({4.1, 2.9}), ElementsAre(-1, -1, 0, 1, 0));
}

TEST_F(Sorting, LeavesOverWhatIsBeyondTheGate) {
  put({2.79, 2.81, 0.81, 0.79});
  EXPECT_THAT(groups({1.8}), ElementsAre(0, -1, 0, -1));
}

TEST_F(Sorting, LeavesOutWhatTheCourseLeftOut) {
  put({1.8, 1.8, 1.8});
  roles_ = {FitRole::outlier, FitRole::inlier, FitRole::unused};
  EXPECT_THAT(groups({1.8}), ElementsAre(-1, 0, -1));
}

TEST_F(Sorting, GroupsNothingThatIsNowhere) {
  put({std::numeric_limits<double>::quiet_NaN()});
  EXPECT_THAT(groups({1.8}), ElementsAre(-1));
}

TEST_F(Sorting, FoundsABoundaryWhereSixLeftoversLieTogether) {
  put({3.5, 3.6, 3.4, 3.5, 3.5});
  EXPECT_THAT(founded(), IsEmpty());
  put({3.5});
  EXPECT_THAT(founded(), ElementsAre(::testing::DoubleNear(3.5, 1e-9)));
}

TEST_F(Sorting, FoundsNothingOnWhatLiesTooWide) {
  put({3.0, 3.2, 3.4, 3.6, 3.8, 4.0});
  EXPECT_THAT(founded(), IsEmpty());
}

TEST_F(Sorting, FoundsNothingFarAway) {
  put(std::vector<double>(6, 3.5), 34);  // the last one stands at 44 m
  EXPECT_EQ(founded().size(), 1U);
  features_.clear();
  put(std::vector<double>(6, 3.5), 36);
  EXPECT_THAT(founded(), IsEmpty());
}

TEST_F(Sorting, FoundsNothingNearAnExistingBoundary) {
  put(std::vector<double>(8, 3.5));
  EXPECT_THAT(founded({1.6}), IsEmpty());
  EXPECT_EQ(founded({1.4}).size(), 1U);
}

TEST_F(Sorting, FoundsTheDensestPlaceFirst) {
  put(std::vector<double>(6, 1.0));
  put(std::vector<double>(9, -2.5));
  EXPECT_THAT(founded(), ElementsAre(::testing::DoubleNear(-2.5, 1e-9), ::testing::DoubleNear(1.0, 1e-9)));
}

TEST_F(Sorting, LetsTheDenserOfTwoNearPlacesWin) {
  put(std::vector<double>(6, 1.0));
  put(std::vector<double>(9, 2.5));  // nearer than 2 m to the first
  EXPECT_THAT(founded(), ElementsAre(::testing::DoubleNear(2.5, 1e-9)));
}

TEST_F(Sorting, FoundsNothingOnBarsThatAreSeenOnce) {
  put(std::vector<double>(8, 3.5), 10, config_.birth_confidence - 0.01);
  EXPECT_THAT(founded(), IsEmpty());
  for (Feature& feature : features_) feature.track_id = 3;  // but a tracked vehicle was looked at before
  EXPECT_EQ(founded().size(), 1U);
}

}  // namespace
}  // namespace lanefuse
