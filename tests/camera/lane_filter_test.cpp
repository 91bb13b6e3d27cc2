// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_filter.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/pose2.hpp"
#include "core/random.hpp"
#include "painted_road.hpp"

namespace lanefuse {
namespace {

using State = LaneState;

const CameraModel kCamera(serial_camera());

CameraPose usual_pose() {
  CameraPose pose;
  pose.mounting = usual_mounting();
  return pose;
}

State::Vector some_state(Random& random) {
  State::Vector state;
  state << random.uniform(-0.6, 0.6), random.uniform(3.2, 3.9), random.uniform(-0.02, 0.02),
      random.uniform(-8e-4, 8e-4), random.uniform(-4e-6, 4e-6), random.uniform(-0.008, 0.008),
      random.uniform(-4e-5, 4e-5), 0;
  return state;
}

State::Matrix wide_covariance() {
  State::Vector sigma;
  sigma << 0.3, 0.25, 0.01, 5e-4, 5e-6, 0.006, 4e-5, 0.02;
  return sigma.cwiseAbs2().asDiagonal();
}

/// Exact edges of both markings as the camera sees them.
std::vector<EdgeMeasurement> exact_edges(const RoadSight& sight, const State::Vector& truth) {
  std::vector<EdgeMeasurement> edges;
  int window = 0;
  for (const Side side : {Side::left, Side::right}) {
    for (double x = 7; x < 80; x *= 1.08) {
      const auto pixel = sight.pixel({x, State::edge(truth, side).y(x)}, truth[State::kPitch],
                                     truth[State::kVerticalCurvature]);
      if (!pixel) continue;
      EdgeMeasurement edge;
      edge.ray = sight.ray(*pixel);
      edge.side = side;
      edge.window = window++;
      edges.push_back(edge);
    }
  }
  return edges;
}

TEST(LaneFilter, JacobianEqualsFiniteDifferences) {
  Random random(1, "states");
  const RoadSight sight(kCamera, usual_pose());
  for (int i = 0; i < 100; ++i) {
    const State::Vector state = some_state(random);
    const double x = random.uniform(8, 60);
    const Side side = random.chance(0.5) ? Side::left : Side::right;
    const auto pixel = sight.pixel({x, State::edge(state, side).y(x)}, state[State::kPitch],
                                   state[State::kVerticalCurvature]);
    ASSERT_TRUE(pixel);
    const RoadSight::Ray ray = sight.ray(*pixel);
    const auto residual = edge_residual(sight, ray, side, state);
    ASSERT_TRUE(residual);
    EXPECT_NEAR(residual->pixels, 0, 1e-6);
    const std::array<double, State::kSize> steps = {1e-4, 1e-4, 1e-6, 1e-8, 1e-10, 1e-6, 1e-8, 1e-6};
    for (int k = 0; k < State::kSize; ++k) {
      const State::Vector step = steps[static_cast<std::size_t>(k)] * State::Vector::Unit(k);
      const double more = edge_residual(sight, ray, side, state + step)->pixels;
      const double less = edge_residual(sight, ray, side, state - step)->pixels;
      // The residual falls as the expected column grows.
      const double difference = -(more - less) / (2 * steps[static_cast<std::size_t>(k)]);
      EXPECT_NEAR(residual->jacobian[k], difference, 2e-3 * std::abs(difference) + 1e-3) << "state " << k;
    }
  }
}

TEST(LaneFilter, FindsTheExactLaneFromExactEdges) {
  Random random(2, "states");
  const RoadSight sight(kCamera, usual_pose());
  for (int i = 0; i < 50; ++i) {
    const State::Vector truth = some_state(random);
    LaneFilter filter({});
    filter.state().mean = truth;
    filter.state().mean[State::kOffset] += random.normal(0.1);
    filter.state().mean[State::kHeading] += random.normal(0.004);
    filter.state().mean[State::kPitch] += random.normal(0.004);
    filter.state().covariance = wide_covariance();
    LaneFilter::Fit fit;
    const auto edges = exact_edges(sight, truth);
    filter.update(sight, edges, fit);
    EXPECT_NEAR(filter.state().mean[State::kOffset], truth[State::kOffset], 0.01);
    EXPECT_NEAR(filter.state().mean[State::kPitch], truth[State::kPitch], 3e-4);
    EXPECT_NEAR(filter.state().mean[State::kWidth], truth[State::kWidth], 0.02);
    EXPECT_EQ(fit.inliers[0] + fit.inliers[1], static_cast<int>(edges.size()));
  }
}

TEST(LaneFilter, TakesTheLikeliestOfSeveralBarsAndIgnoresStrays) {
  Random random(3, "strays");
  const RoadSight sight(kCamera, usual_pose());
  const State::Vector truth = some_state(random);
  auto exact = exact_edges(sight, truth);
  std::vector<EdgeMeasurement> edges;
  for (const EdgeMeasurement& edge : exact) {
    const bool missing = random.chance(0.3);
    if (!missing) edges.push_back(edge);
    EdgeMeasurement stray = edge;
    stray.ray.ray += random.uniform(-25, 25) * stray.ray.ray_per_column;
    edges.push_back(stray);
  }
  LaneFilter filter({});
  filter.state().mean = truth;
  filter.state().mean[State::kPitch] += 0.007;
  filter.state().covariance = wide_covariance();
  LaneFilter::Fit fit;
  filter.update(sight, edges, fit);
  for (const double x : {10.0, 30.0, 60.0}) {
    EXPECT_NEAR(State::edge(filter.state().mean, Side::left).y(x), State::edge(truth, Side::left).y(x),
                0.05 + x / 500);
  }
}

TEST(LaneFilter, MovesTheLaneAsTheCarMoves) {
  Random random(4, "states");
  for (int i = 0; i < 50; ++i) {
    LaneFilter filter({});
    filter.state().mean = some_state(random);
    filter.state().mean[State::kCurvatureRate] = 0;
    const Clothoid before = State::edge(filter.state().mean, Side::left);
    const double yaw_rate = random.uniform(-0.05, 0.05);
    filter.predict(0.04, 30, yaw_rate);
    const double way = 1.2;
    const double turn = yaw_rate * 0.04;
    const Pose2 old_from_new(way, way * turn / 2, turn);
    const Clothoid expected = transform(before, old_from_new);
    const Clothoid after = State::edge(filter.state().mean, Side::left);
    EXPECT_NEAR(after.lateral_offset, expected.lateral_offset, 2e-3);
    EXPECT_NEAR(after.heading, expected.heading, 1e-4);
  }
}

TEST(LaneFilter, BehindACrossedMarkingLiesALaneOfTheSameWidth) {
  LaneFilter filter({});
  filter.state().mean << -1.9, 3.5, 0, 0, 0, 0, 0, 0;
  filter.state().covariance = 1e-4 * State::Matrix::Identity();
  const double crossed = State::edge(filter.state().mean, Side::left).lateral_offset;
  const double crossed_variance = filter.edge_covariance(Side::left)(0, 0);
  filter.cross_marking(Side::left, 0.15);
  const Clothoid right = State::edge(filter.state().mean, Side::right);
  EXPECT_NEAR(right.lateral_offset, crossed + 0.15, 1e-12)
      << "the other edge of the marking that was crossed";
  EXPECT_NEAR(filter.edge_covariance(Side::right)(0, 0), crossed_variance, 1e-9);
  EXPECT_GT(filter.edge_covariance(Side::left)(0, 0), 0.03);
}

}  // namespace
}  // namespace lanefuse
