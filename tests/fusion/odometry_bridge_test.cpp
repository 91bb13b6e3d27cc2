// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "support/window_view.hpp"

namespace lanefuse {
namespace {

using testing::EdgeKind;
using testing::WindowView;

constexpr Witness kCamera{Source::serial_camera, 1};

Time at(double seconds) { return from_nanoseconds(0) + from_seconds(seconds); }

/// A winding way whose first and last keyframes have measurements, those between them none.
class Bridge : public ::testing::Test {
 protected:
  Bridge() {
    config_.odometry = {0.02, 2, 0.5, 0.02};
    Pose2 car{50, -20, 3.1};  // the headings wrap on the way
    window_.advance(at(0), car);
    const auto feature = window_.add_feature(car * Pose2{30, 2, 0}, at(0));
    window_.add_measurement(window_.graph().chain()[0], feature.value(), {30, 2, 0}, {1, 0, 1, 1}, kCamera);
    for (std::size_t i = 0; i < 3; ++i) {
      car = car * Pose2{4.0 + static_cast<double>(i), 0.3, 0.4 - 0.15 * static_cast<double>(i)};
      window_.advance(at(0.2 * static_cast<double>(i + 1)), car);
    }
    const WindowView view(window_);
    for (const std::size_t i : view.edges_of(EdgeKind::odometry)) steps_.push_back(view.edge(i));
    window_.prune(at(1), car);
  }

  [[nodiscard]] Pose2 whole_way() const {
    Pose2 way;
    for (const Edge& step : steps_) way = way * step.measurement;
    return way;
  }

  FusionConfig config_;
  SlidingWindow window_{config_};
  std::vector<Edge> steps_;  ///< the odometry edges before the keyframes between went
};

TEST_F(Bridge, JoinsWhatIsLeftOfTheChain) {
  ASSERT_EQ(window_.keyframe_count(), 2U);
  const WindowView view(window_);
  const auto odometry = view.edges_of(EdgeKind::odometry);
  ASSERT_EQ(odometry.size(), 1U);
  const Edge& edge = view.edge(odometry[0]);
  EXPECT_EQ(view.keyframe(edge.from).time, at(0));
  EXPECT_TRUE(view.vertex(edge.to).fixed);
  const Pose2 off = whole_way().inverse() * edge.measurement;
  EXPECT_LT(Eigen::Vector3d(off.x, off.y, off.heading).norm(), 1e-12);
  EXPECT_LT(view.error_of(odometry[0]).norm(), 1e-12);
}

TEST_F(Bridge, KnowsAsMuchOfTheWayAsTheStepsKnew) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  constexpr int kDraws = 40000;
  for (int draw = 0; draw < kDraws; ++draw) {
    Pose2 way;
    for (const Edge& step : steps_) {
      Eigen::Vector3d noise = step.information.diagonal().cwiseInverse().cwiseSqrt();
      for (double& n : noise) n *= normal(random);
      way = way * step.measurement * Pose2{noise[0], noise[1], noise[2]};
    }
    const Pose2 off = whole_way().inverse() * way;
    const Eigen::Vector3d e(off.x, off.y, off.heading);
    scatter += e * e.transpose() / kDraws;
  }
  const WindowView view(window_);
  const auto odometry = view.edges_of(EdgeKind::odometry);
  const Eigen::Matrix3d root = view.edge(odometry.at(0)).information.llt().matrixL();
  // Whitened by the edge's information, the scatter is that of white noise.
  const Eigen::Matrix3d whitened = root.transpose() * scatter * root;
  EXPECT_LT((whitened - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.04) << whitened;
}

}  // namespace
}  // namespace lanefuse
