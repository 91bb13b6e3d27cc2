// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/association.hpp"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lanefuse {
namespace {

const Pose2 kMeasured{20, 3, 0.1};
const Eigen::Matrix3d kInformation = Eigen::Vector3d(1, 100, 1e4).asDiagonal();
constexpr FeatureAssociation::Id kFeature = 5;

/// Whether a fused feature that lies like this from the measured one, in its frame, is taken for the same.
bool is_associated(const Pose2& offset, const Pose2& measured = kMeasured) {
  const AssociationConfig config;
  FeatureAssociation association(config, 8);
  association.clear();
  association.add(kFeature, measured * offset);
  association.begin_set();
  return association.claim(measured, kInformation).has_value();
}

TEST(Gates, StandAlongTheMarking) {
  EXPECT_TRUE(is_associated({1.19, 0, 0}));
  EXPECT_TRUE(is_associated({-1.19, 0, 0}));
  EXPECT_FALSE(is_associated({1.21, 0, 0}));
  EXPECT_FALSE(is_associated({-1.21, 0, 0}));
}

TEST(Gates, StandAcrossItAndWidenWithTheDistance) {
  EXPECT_TRUE(is_associated({0, 0.67, 0}));
  EXPECT_TRUE(is_associated({0, -0.67, 0}));
  EXPECT_FALSE(is_associated({0, 0.69, 0}));
  EXPECT_FALSE(is_associated({0, -0.69, 0}));
  EXPECT_TRUE(is_associated({0, 0.97, 0}, {100, 3, 0.1}));
  EXPECT_FALSE(is_associated({0, 1.01, 0}, {100, 3, 0.1}));
  EXPECT_FALSE(is_associated({0, 0.61, 0}, {-10, 3, 0.1})) << "behind the car they do not shrink or grow";
  EXPECT_TRUE(is_associated({0, 0.59, 0}, {-10, 3, 0.1}));
}

TEST(Gates, StandInTheHeadingWithTwiceTheMeasuredSigma) {
  const double gate = 6 * std::numbers::pi / 180 + 2 * 0.01;
  EXPECT_TRUE(is_associated({0, 0, gate - 0.001}));
  EXPECT_TRUE(is_associated({0, 0, 0.001 - gate}));
  EXPECT_FALSE(is_associated({0, 0, gate + 0.001}));
  EXPECT_FALSE(is_associated({0, 0, -gate - 0.001}));
}

class AssociationOfAPair : public ::testing::Test {
 protected:
  AssociationOfAPair() {
    association_.clear();
    association_.add(0, kMeasured * Pose2{1, 0, 0});    // 1 sigma away
    association_.add(1, kMeasured * Pose2{0, 0.2, 0});  // nearer in metres, but 2 sigmas away
    association_.begin_set();
  }
  std::optional<FeatureAssociation::Id> claim() { return association_.claim(kMeasured, kInformation); }

  AssociationConfig config_;
  FeatureAssociation association_{config_, 8};
};

TEST_F(AssociationOfAPair, GivesTheSmallestMahalanobisDistance) { EXPECT_EQ(claim(), 0U); }

TEST_F(AssociationOfAPair, GivesAFeatureAwayOnceASet) {
  EXPECT_EQ(claim(), 0U);
  EXPECT_EQ(claim(), 1U);
  EXPECT_EQ(claim(), std::nullopt);
  association_.begin_set();
  EXPECT_EQ(claim(), 0U);
}

TEST_F(AssociationOfAPair, KeepsWhatASetCreatedFromThatSet) {
  association_.add_claimed(2, kMeasured);
  EXPECT_EQ(claim(), 0U);
  association_.begin_set();
  EXPECT_EQ(claim(), 2U);
}

TEST_F(AssociationOfAPair, ForgetsAllInANewCycle) {
  association_.clear();
  association_.begin_set();
  EXPECT_EQ(claim(), std::nullopt);
}

TEST(FeatureAssociation, ReachesBeyondItsSlices) {
  const AssociationConfig config;
  for (const double x : {-300.0, -21.0, -20.0, 219.0, 221.0, 900.0}) {
    EXPECT_TRUE(is_associated({1, 0, 0}, {x, 0, 0})) << x;
    EXPECT_TRUE(is_associated({-1, 0, 0}, {x, 0, 0})) << x;
  }
}

/// What claim() promises, without slices.
std::optional<FeatureAssociation::Id> search_all(const std::vector<Pose2>& features, const Pose2& measured) {
  const AssociationConfig config;
  std::optional<FeatureAssociation::Id> best;
  double least = std::numeric_limits<double>::infinity();
  for (FeatureAssociation::Id id = 0; id < features.size(); ++id) {
    const Pose2 offset = measured.inverse() * features[id];
    const Eigen::Vector3d e(offset.x, offset.y, offset.heading);
    const double across = config.across + config.across_per_metre * std::max(0.0, measured.x);
    const double heading = config.heading_deg * std::numbers::pi / 180 + 2 / std::sqrt(kInformation(2, 2));
    if (std::abs(e[0]) >= config.along || std::abs(e[1]) >= across || std::abs(e[2]) >= heading) continue;
    const double distance = e.dot(kInformation * e);
    if (distance < least) {
      least = distance;
      best = id;
    }
  }
  return best;
}

RC_GTEST_PROP(FeatureAssociation, FindsWhatASearchThroughAllFinds, ()) {
  const double turn =
      *rc::gen::inRange(-31, 32) * 0.1;  // markings may lead anywhere, even across the car's way
  const auto pose = rc::gen::apply(
      [turn](int x, int y, int h) {
        return Pose2{x * 0.13, y * 0.11, wrap_angle(turn + h * 0.02)};
      },
      rc::gen::inRange(-200, 200), rc::gen::inRange(-12, 12), rc::gen::inRange(-5, 6));
  const auto features = *rc::gen::container<std::vector<Pose2>>(pose);
  const Pose2 measured = *pose;
  const AssociationConfig config;
  FeatureAssociation association(config, 8);
  association.clear();
  for (FeatureAssociation::Id id = 0; id < features.size(); ++id) association.add(id, features[id]);
  association.begin_set();
  RC_ASSERT(association.claim(measured, kInformation) == search_all(features, measured));
}

}  // namespace
}  // namespace lanefuse
