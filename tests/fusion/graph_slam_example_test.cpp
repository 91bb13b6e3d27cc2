// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/paper_scenes.hpp"

/// The paper's figure "A GraphSLAM example": the graph of two cycles, edge by edge.
namespace lanefuse {
namespace {

using testing::EdgeKind;

class GraphSlamExample : public ::testing::Test {
 protected:
  std::unique_ptr<testing::FusionDrive> drive_ = testing::graph_slam_example();
  const testing::WindowView window_ = drive_->view();
  const PoseGraph& graph_ = window_.graph();

  [[nodiscard]] std::vector<VertexId> vertices(VertexRole role) const {
    std::vector<VertexId> ids;
    for (VertexId id = 0; id < graph_.vertices.size(); ++id) {
      if (graph_.vertices[id].role == role) ids.push_back(id);
    }
    return ids;
  }
  /// The ends of all edges of a kind and source.
  [[nodiscard]] std::vector<std::pair<VertexId, VertexId>> ends(EdgeKind kind, Source source) const {
    std::vector<std::pair<VertexId, VertexId>> result;
    for (const std::size_t i : window_.edges_of(kind)) {
      if (window_.origin(i).source == source) result.emplace_back(graph_.edges[i].from, graph_.edges[i].to);
    }
    return result;
  }
};

using Ends = std::vector<std::pair<VertexId, VertexId>>;

TEST_F(GraphSlamExample, HasThePapersVerticesAndEdges) {
  const auto poses = vertices(VertexRole::pose);
  ASSERT_EQ(poses.size(), 2U);
  ASSERT_EQ(vertices(VertexRole::landmark).size(), 5U);
  ASSERT_EQ(graph_.edges.size(), 11U);
  const VertexId before = poses[0];
  const VertexId now = poses[1];

  const auto sightings = testing::sightings(window_);
  ASSERT_EQ(sightings.size(), 2U);
  const auto& [keyframe_before, left_before, right_before] = sightings[0];
  const auto& [keyframe_now, left_now, right_now] = sightings[1];
  EXPECT_EQ(keyframe_before, before);
  EXPECT_EQ(keyframe_now, now);

  EXPECT_EQ(window_.edges_of(EdgeKind::odometry).size(), 1U);
  EXPECT_EQ(ends(EdgeKind::measurement, Source::objects),
            (Ends{{before, left_before}, {before, right_before}, {now, left_now}, {now, right_now}}));
  EXPECT_EQ(ends(EdgeKind::width, Source::objects),
            (Ends{{right_before, left_before}, {right_now, left_now}}));
  EXPECT_EQ(ends(EdgeKind::smoothing, Source::objects),
            (Ends{{left_before, left_now}, {right_before, right_now}}));

  const auto serial = ends(EdgeKind::measurement, Source::serial_camera);
  const auto high_resolution = ends(EdgeKind::measurement, Source::high_resolution_camera);
  ASSERT_EQ(serial.size(), 1U);
  ASSERT_EQ(high_resolution.size(), 1U);
  EXPECT_EQ(serial[0].first, before);
  EXPECT_EQ(high_resolution[0].first, now);
  EXPECT_EQ(serial[0].second, high_resolution[0].second) << "f* is one feature";
}

TEST_F(GraphSlamExample, PutsASwitchOnEachSmoothingEdgeAndOnNothingElse) {
  EXPECT_EQ(graph_.switches.size(), 2U);
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    EXPECT_EQ(graph_.edges[i].switch_index != kNoSwitch, window_.origin(i).kind == EdgeKind::smoothing);
  }
}

TEST_F(GraphSlamExample, FusesTheTwoCamerasByTheirInformation) {
  for (const Feature& feature : drive_->fusion().fused()) {
    if (feature.track_id != kNoTrack) continue;
    EXPECT_GT(feature.y, -1.8);
    EXPECT_LT(feature.y, -1.75);
  }
}

}  // namespace
}  // namespace lanefuse
