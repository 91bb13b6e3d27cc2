// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/paper_scenes.hpp"

/// The paper's figure of the lane-changing object: what width edges, smoothing edges and switches are for.
namespace lanefuse {
namespace {

using testing::LaneChangeScene;
using testing::Sighting;
using testing::WindowView;

bool has_cameras_too(const WindowView& window, VertexId feature) {
  const auto& hits = window.feature(feature).hits;
  return hits[static_cast<std::size_t>(Source::serial_camera)] > 0 &&
         hits[static_cast<std::size_t>(Source::high_resolution_camera)] > 0;
}

double y_of(const WindowView& window, VertexId vertex) { return window.vertex(vertex).pose.y; }

/// How far the widths of all sightings are from the lane's, at most.
double worst_width(const WindowView& window) {
  double worst = 0;
  for (const Sighting& sighting : testing::sightings(window)) {
    worst = std::max(worst, std::abs(testing::width_of(window, sighting) - testing::kLaneWidthOfScene));
  }
  return worst;
}

/// The largest step across the road between successive features of one side in one lane.
double worst_step(const WindowView& window) {
  const auto all = testing::sightings(window);
  double worst = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (i == LaneChangeScene::kBefore) continue;
    worst = std::max({worst, std::abs(y_of(window, all[i].left) - y_of(window, all[i - 1].left)),
                      std::abs(y_of(window, all[i].right) - y_of(window, all[i - 1].right))});
  }
  return worst;
}

TEST(LaneChangingObject, IsAssociatedWithTheMarkingsItDrivesAlong) {
  const auto drive = LaneChangeScene{}.run();
  const WindowView view = drive->view();
  const auto all = testing::sightings(view);
  ASSERT_EQ(all.size(), LaneChangeScene::kOffsets.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool in_left_lane = i < LaneChangeScene::kBefore;
    EXPECT_EQ(has_cameras_too(view, all[i].left), !in_left_lane) << i;
    EXPECT_TRUE(has_cameras_too(view, all[i].right)) << i;
    EXPECT_NEAR(y_of(view, in_left_lane ? all[i].right : all[i].left), 1.75, 0.1) << i;
  }
}

TEST(LaneChangingObject, TearsItsLaneApartWithoutWidthAndSmoothing) {
  const auto drive = LaneChangeScene{}.run();
  EXPECT_GT(worst_width(drive->view()), 0.25);
}

TEST(LaneChangingObject, IsOneLaneWideAgainWithWidthEdges) {
  const auto without = LaneChangeScene{}.run();
  const auto with = LaneChangeScene{.width_edges = true}.run();
  EXPECT_LT(worst_width(with->view()), 0.1);
  EXPECT_LT(worst_width(with->view()), worst_width(without->view()) / 3);
}

TEST(LaneChangingObject, IsSmoothButForItsLaneChangeWithSmoothingEdges) {
  const auto width = LaneChangeScene{.width_edges = true}.run();
  const auto both = LaneChangeScene{.width_edges = true, .smoothing_edges = true}.run();
  EXPECT_LT(worst_step(both->view()), worst_step(width->view()));
  EXPECT_LT(worst_width(both->view()), 0.1);
}

TEST(LaneChangingObject, SwitchesOffTheTwoEdgesAcrossItsLaneChangeAlone) {
  const auto drive = LaneChangeScene{.width_edges = true, .smoothing_edges = true}.run();
  const WindowView view = drive->view();
  const auto all = testing::sightings(view);
  const Sighting& last = all[LaneChangeScene::kBefore - 1];
  const Sighting& first = all[LaneChangeScene::kBefore];
  int off = 0;
  for (const std::size_t i : view.edges_of(testing::EdgeKind::smoothing)) {
    const Edge& edge = view.edge(i);
    const bool across = (edge.from == last.left && edge.to == first.left) ||
                        (edge.from == last.right && edge.to == first.right);
    const double value = view.switch_of(i);
    if (across) {
      EXPECT_EQ(value, 0);
      ++off;
    } else {
      EXPECT_GT(value, 0.5);
    }
  }
  EXPECT_EQ(off, 2);
}

TEST(LaneChangingObject, WouldDragTheFeaturesAlongWithoutSwitches) {
  FusionConfig config = testing::thorough();
  const auto farthest_from_lanes = [&](bool switchable) {
    config.switchable = switchable;
    testing::FusionDrive drive(config);
    for (int i = 0; i < 8; ++i) {
      drive.step({3.0 * i, 0, 0}, {testing::vehicle_set(drive, 30, i < 4 ? 3.5 : 0.0)});
    }
    double farthest = 0;
    const WindowView view = drive.view();
    for (const Sighting& s : testing::sightings(view)) {
      const double y = y_of(view, s.left);
      farthest = std::max(farthest, std::min(std::abs(y - 5.25), std::abs(y - 1.75)));
    }
    return farthest;
  };
  EXPECT_LT(farthest_from_lanes(true), 0.05);
  EXPECT_GT(farthest_from_lanes(false), 0.5);
}

}  // namespace
}  // namespace lanefuse
