// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/paper_scenes.hpp"

namespace lanefuse {
namespace {

using testing::EdgeKind;
using testing::edges_of;
using testing::FusionDrive;

FusionConfig without(bool FusionConfig::*edges) {
  FusionConfig config;
  config.*edges = false;
  return config;
}

void follow_a_vehicle(FusionDrive& drive, int cycles) {
  for (int i = 0; i < cycles; ++i) drive.step({3.0 * i, 0, 0}, {testing::vehicle_set(drive, 30, 0)});
}

TEST(Ties, StandBetweenTheSidesAndAlongTheWayOfAWitness) {
  FusionDrive drive;
  follow_a_vehicle(drive, 4);
  EXPECT_EQ(edges_of(drive.window(), EdgeKind::width).size(), 4U);
  EXPECT_EQ(edges_of(drive.window(), EdgeKind::smoothing).size(), 6U);
  const testing::WindowView view = drive.view();
  for (const std::size_t i : view.edges_of(EdgeKind::width)) {
    const Edge& edge = view.edge(i);
    EXPECT_EQ(view.feature(edge.from).side, Side::right);
    EXPECT_EQ(view.feature(edge.to).side, Side::left);
    EXPECT_NEAR(view.error_of(i).y(), 0, 1e-9);
  }
  for (const std::size_t i : view.edges_of(EdgeKind::smoothing)) {
    const Edge& edge = view.edge(i);
    EXPECT_EQ(view.feature(edge.from).side, view.feature(edge.to).side);
    EXPECT_NEAR(view.vertex(edge.to).pose.x - view.vertex(edge.from).pose.x, 3, 1e-6);
  }
}

TEST(Ties, AreLeftOutAsConfigured) {
  FusionDrive no_width(without(&FusionConfig::width_edges));
  follow_a_vehicle(no_width, 4);
  EXPECT_TRUE(edges_of(no_width.window(), EdgeKind::width).empty());
  EXPECT_FALSE(edges_of(no_width.window(), EdgeKind::smoothing).empty());
  FusionDrive no_smoothing(without(&FusionConfig::smoothing_edges));
  follow_a_vehicle(no_smoothing, 4);
  EXPECT_TRUE(edges_of(no_smoothing.window(), EdgeKind::smoothing).empty());
  EXPECT_FALSE(edges_of(no_smoothing.window(), EdgeKind::width).empty());
}

TEST(Ties, LeaveOutAWitnessOfUnknownWidthAndFeaturesOfNoTrack) {
  FusionDrive drive;
  for (int i = 0; i < 4; ++i) {
    drive.step({3.0 * i, 0, 0},
               {drive.set(Source::objects, testing::vehicle_features(30, 0)),
                drive.set(Source::high_resolution_camera, {testing::feature_at({50, 9, 0})})});
  }
  EXPECT_TRUE(edges_of(drive.window(), EdgeKind::width).empty());
  EXPECT_EQ(edges_of(drive.window(), EdgeKind::smoothing).size(), 6U);
}

TEST(Ties, SurviveTheLossOfTheirPast) {
  FusionDrive drive;
  follow_a_vehicle(drive, 60);  // 177 m: the first features are long behind
  const GraphSize size = drive.fusion().size();
  EXPECT_LT(size.features, 2 * 15U);
  EXPECT_EQ(edges_of(drive.window(), EdgeKind::smoothing).size(), size.features - 2);
}

TEST(Ties, EndWithATrackThatWasAwayForAsLongAsAFeatureIsKept) {
  FusionConfig config;
  config.drop_age_s = 1;
  FusionDrive drive(config);
  drive.step({}, {testing::vehicle_set(drive, 30, 0)});
  const auto stand = [&](int cycles) {
    // A camera keeps the features alive.
    for (int i = 0; i < cycles; ++i)
      drive.step({}, {drive.set(Source::serial_camera,
                                {testing::feature_at({30, 1.75, 0}), testing::feature_at({30, -1.75, 0})})});
  };
  stand(5);
  drive.step({}, {testing::vehicle_set(drive, 40, 0)});
  EXPECT_EQ(edges_of(drive.window(), EdgeKind::smoothing).size(), 2U);
  stand(40);
  drive.step({}, {testing::vehicle_set(drive, 50, 0)});
  EXPECT_EQ(edges_of(drive.window(), EdgeKind::smoothing).size(), 0U)
      << "the features at 40 m have gone, too";
  stand(40);
  drive.step({}, {testing::vehicle_set(drive, 30, 0)});
  stand(40);
  drive.step({}, {testing::vehicle_set(drive, 33, 0)});
  EXPECT_EQ(edges_of(drive.window(), EdgeKind::smoothing).size(), 0U)
      << "those at 30 m are there, but it was long ago";
}

TEST(SwitchStates, TellWhereAWitnessJumped) {
  FusionDrive drive;
  for (int i = 0; i < 8; ++i) {
    drive.step({3.0 * i, 0, 0}, {testing::vehicle_set(drive, 30, i < 4 ? 3.5 : 0.0)});
  }
  std::vector<SwitchState> states;
  drive.fusion().switch_states(states);
  ASSERT_EQ(states.size(), 2U * 7);
  for (const SwitchState& state : states) {
    const bool jumped = std::abs(state.from.y() - state.to.y()) > 1;
    EXPECT_EQ(state.value < 0.5, jumped) << state.from.x();
    EXPECT_EQ(state.track_id, 7);
    EXPECT_NEAR(state.to.x() - state.from.x(), 3, 0.01) << "in the vehicle frame";
  }
}

}  // namespace
}  // namespace lanefuse
