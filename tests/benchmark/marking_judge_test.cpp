// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/marking_judge.hpp"

#include <gtest/gtest.h>

#include "benchmark/lane_track_judge.hpp"
#include "simulation/camera_image_model.hpp"
#include "simulation/drive_road.hpp"
#include "simulation/preset.hpp"
#include "simulation/traffic.hpp"

namespace lanefuse {
namespace {

/// A moment on a motorway without other vehicles, seen by the high-resolution camera.
class JudgeTest : public ::testing::Test {
 protected:
  JudgeTest() {
    TrafficConfig config = nominal_traffic(preset_);
    config.preset.vehicles_per_metre_lane = 0;
    scene_ = Traffic(there_.road, config, there_.start, 1).scene(Time{});
    truth_.emplace(scene_, camera_, mounting_);
  }

  /// A bar on every painted row of every line, `off` [px] to the right of its centre.
  CameraView view(double off) const {
    CameraView view;
    for (const int line : truth_->lines()) {
      for (double row = camera_.intrinsics().cy; row < 890; row += 1) {
        const auto place = truth_->marking(line, row);
        if (!place || !place->visible() || place->ground.x() > 140) continue;
        view.bars.push_back({row, place->left + off, place->right + off, true});
      }
    }
    return view;
  }

  /// A feature every ten metres on the line, `off` [m] to the left of it, with a sigma of .1 m.
  std::vector<Feature> features(double off) const {
    std::vector<Feature> features;
    for (const int line : truth_->lines()) {
      for (double ahead = 10; ahead < 120; ahead += 10) {
        const auto place = truth_->marking_at(line, scene_.ego.station + ahead);
        const auto next = truth_->marking_at(line, scene_.ego.station + ahead + 1);
        if (!place || !next || std::abs(place->ground.y()) > 9) continue;
        const Eigen::Vector2d way = next->ground - place->ground;
        features.push_back({place->ground.x(), place->ground.y() + off, std::atan2(way.y(), way.x()), 0.9});
        features.back().covariance = Eigen::Vector3d(0.01, 0.01, 1e-4).asDiagonal();
      }
    }
    return features;
  }

  MarkingFigures figures(double bars_off, double features_off) {
    MarkingFigures figures;
    judge_markings(scene_, *truth_, camera_.intrinsics(), view(bars_off), features(features_off), figures);
    return figures;
  }

  SensorPreset preset_ = nominal_preset();
  DriveRoad there_ = drive_road({}, RoadKind::gentle, 1, preset_.road, 1);
  CameraModel camera_{high_resolution_camera_intrinsics()};
  Mounting mounting_{0, 0, 1.25, 0, 0, 0};
  Scene scene_;
  std::optional<ImageTruth> truth_;
};

TEST_F(JudgeTest, ExactBarsAreFoundAndTrue) {
  const MarkingFigures exact = figures(0, 0);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_GT(exact.bins[i].found.of, 5u) << i;
    EXPECT_GT(exact.bins[i].found.value(), 0.99) << i;
    EXPECT_EQ(exact.bins[i].believed_falsely.count, 0u) << i;
    EXPECT_LT(exact.bins[i].lateral_px.rmse(), 1e-3) << i;
    EXPECT_LT(exact.bins[i].lateral.rmse(), 0.01) << i;
    EXPECT_EQ(exact.bins[i].lateral.coverage(), 1) << i;
  }
}

TEST_F(JudgeTest, ErrorsAreMeasuredInPixelsAndMetres) {
  const MarkingFigures shifted = figures(1.5, 0.3);
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_NEAR(shifted.bins[i].lateral_px.mean(), 1.5, 1e-3);
    EXPECT_NEAR(shifted.bins[i].lateral.mean(), 0.3, 0.01);
    EXPECT_EQ(shifted.bins[i].lateral.coverage(), 0) << "three sigma off is not within two";
  }
}

TEST_F(JudgeTest, BarsBesidePaintAreFalse) {
  const MarkingFigures wrong = figures(90, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(wrong.bins[i].believed_falsely.value(), 0.95) << i;
    EXPECT_LT(wrong.bins[i].found.value(), 0.05) << i;
  }
}

TEST_F(JudgeTest, AFarLaneTrackIsJudgedWithinItsRangeOnly) {
  LaneTrackFigures figures;
  SerialLane lane;
  lane.left.emplace();
  lane.right.emplace();
  lane.left->range_end = 25;
  lane.right->range_end = 35;
  judge_lane(scene_, *truth_, lane, figures);
  EXPECT_EQ(figures.tracked.count, 1u);
  EXPECT_EQ(figures.mean_range(), 25);
  EXPECT_EQ(figures.lateral[2].count, 2u);
  EXPECT_EQ(figures.lateral[3].count, 1u);
  EXPECT_EQ(figures.lateral[4].count, 0u);
  EXPECT_GT(figures.lateral[0].rmse(), 1) << "the lane is not in the middle of the car";
  judge_lane(scene_, *truth_, {}, figures);
  EXPECT_EQ(figures.tracked.value(), 0.5);
}

TEST(BoxOverlap, IsIntersectionOverUnion) {
  const VehicleBox box{0, 0, 10, 10};
  EXPECT_EQ(overlap(box, box), 1);
  EXPECT_NEAR(overlap(box, {5, 0, 15, 10}), 1.0 / 3, 1e-12);
  EXPECT_EQ(overlap(box, {10, 0, 20, 10}), 0);
}

}  // namespace
}  // namespace lanefuse
