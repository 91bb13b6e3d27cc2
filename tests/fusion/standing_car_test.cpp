// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/paper_scenes.hpp"

namespace lanefuse {
namespace {

using testing::FusionDrive;

/// A car that has driven a little, and then stands behind another one.
class StandingCar : public ::testing::Test {
 protected:
  StandingCar() {
    for (int i = 0; i < 20; ++i) look({1.2 * i, 0, 0});
  }

  void look(const Pose2& car) {
    FeatureSet markings = testing::serial_set(drive_, 1.75, 0, 40);
    drive_.step(car, {markings, testing::vehicle_set(drive_, 20, 0.2)});
  }

  FusionDrive drive_;
  const Pose2 place_{1.2 * 19, 0, 0};
};

TEST_F(StandingCar, KeepsTheSameGraphForTenThousandCycles) {
  for (int i = 0; i < 1600; ++i) look(place_);  // longer than a feature is kept that is not seen any more
  const GraphSize before = drive_.fusion().size();
  const auto vertices = drive_.view().graph().vertices;
  for (int i = 0; i < 10'000; ++i) {
    look(place_);
    ASSERT_EQ(drive_.fusion().size().features, before.features) << i;
    ASSERT_EQ(drive_.fusion().size().edges, before.edges) << i;
    ASSERT_EQ(drive_.fusion().size().poses, before.poses) << i;
  }
  const PoseGraph after = drive_.view().graph();
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    EXPECT_NEAR(after.vertices[v].pose.y, vertices[v].pose.y, 1e-3) << "nothing creeps";
  }
}

}  // namespace
}  // namespace lanefuse
