// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/fusion_drive.hpp"

/// A vehicle that its tracker saw changing lane leaves no smooth trail across the lanes.
namespace lanefuse {
namespace {

using testing::FusionDrive;

std::vector<Feature> witness(double x, double y, bool changing) {
  std::vector<Feature> features{testing::witnessed(7, Side::left, {x, y + 1.75, 0}),
                                testing::witnessed(7, Side::right, {x, y - 1.75, 0})};
  for (Feature& feature : features) feature.changing_lane = changing;
  return features;
}

std::size_t smoothing_edges(int changing_from, int changing_to) {
  FusionDrive drive(testing::thorough());
  for (int i = 0; i < 9; ++i) {
    const double y = i < changing_from ? 3.5 : i < changing_to ? 1.75 : 0;
    const bool changing = i >= changing_from && i < changing_to;
    drive.step({3.0 * i, 0, 0}, {drive.set(Source::objects, witness(30, y, changing))});
  }
  return testing::edges_of(drive.window(), testing::EdgeKind::smoothing).size();
}

TEST(ChangingWitness, HasNoSmoothingEdgeWhileItChangesNorFromBeforeToAfter) {
  EXPECT_EQ(smoothing_edges(9, 9), 2U * 8) << "it never changes: one from each sighting to the next";
  EXPECT_EQ(smoothing_edges(0, 9), 0U) << "it changes all the time";
  EXPECT_EQ(smoothing_edges(3, 6), 2U * (2 + 2)) << "three before, three after, nothing between";
}

}  // namespace
}  // namespace lanefuse
