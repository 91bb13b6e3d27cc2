// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "lanes/base_clothoid.hpp"
#include "lanes/marking_features.hpp"

namespace lanefuse {
namespace {

using testing::parting;
using testing::road_of;
using testing::shaken;

class JointFit : public ::testing::Test {
 protected:
  static constexpr std::array kOffsets{5.4, 1.8, -1.8};

  void fit(double y_sigma, double heading_sigma, unsigned seed) {
    const auto features =
        shaken(road_of(road_, {kOffsets.begin(), kOffsets.end()}), y_sigma, heading_sigma, seed);
    std::vector<int> group(features.size());
    const std::size_t each = features.size() / kOffsets.size();
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = static_cast<int>(i / each);
    headings_ = fit_.fit(features);
    joint_ = fit_.refine(features, group, kOffsets.size());
  }

  const Clothoid road_{0, 0.02, -6e-4, 4e-6};
  const BaseClothoidConfig config_;
  BaseClothoidFit fit_{config_};
  std::optional<BaseClothoid> headings_;
  std::optional<BaseClothoid> joint_;
};

TEST_F(JointFit, RecoversTheRoadFromExactFeatures) {
  fit(0, 0, 1);
  ASSERT_TRUE(joint_);
  EXPECT_LT(parting(joint_->clothoid, road_), 0.01);
}

TEST_F(JointFit, BeatsHeadingsAlone) {
  double joint = 0;
  double headings = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    fit(0.1, 0.015, seed);
    joint += parting(joint_->clothoid, road_);
    headings += parting(headings_->clothoid, road_);
  }
  EXPECT_LT(joint, 0.7 * headings);
}

TEST_F(JointFit, KnowsMoreThanHeadingsAlone) {
  fit(0.05, 0.015, 4);
  EXPECT_EQ(joint_->covariance.llt().info(), Eigen::Success);
  for (int i = 0; i < 3; ++i) EXPECT_LT(joint_->covariance(i, i), headings_->covariance(i, i)) << i;
}

}  // namespace
}  // namespace lanefuse
