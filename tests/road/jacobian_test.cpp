// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// What a measurement moves the state by must be the covariance times the gradient of its residual; that is
// had by finite differences, from nothing but the geometry.
#include <cmath>
#include <functional>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "road/camera_view_error.hpp"
#include "road/noiseless_drive.hpp"
#include "road/paint_update.hpp"
#include "road/tracked_lane_update.hpp"
#include "road/vehicle_update.hpp"

namespace lanefuse {
namespace {

using Residual = std::function<double(const RoadState&)>;

/// A state in a bend, all of whose numbers differ from zero and are correlated.
RoadState any_state() {
  Random random(5, "state");
  RoadState state{RoadConfig{}};
  state.add_line(1.7, 0.2);
  state.add_line(-1.9, 0.2);
  GaussianState& numbers = state.numbers();
  for (int i = 0; i < numbers.size(); ++i) {
    const double size = i >= kCurvatures && i < kCrests ? 1e-4 : 0.3 * std::sqrt(numbers.variance(i));
    numbers.set_mean(i, numbers.mean(i) + random.normal(size));
  }
  for (int k = 0; k < RoadAxis::kKnots; ++k)
    numbers.set_mean(kCurvatures + k, 5e-4 + numbers.mean(kCurvatures + k));
  for (int i = 0; i < 20; ++i) {
    SparseRow row;
    for (int k = 0; k < 5; ++k) {
      const int index = random.whole(0, numbers.size() - 1);
      row.add(index, random.normal(1) / std::sqrt(numbers.variance(index)));
    }
    numbers.update(row, 0, 2);
  }
  state.rebuild_axis();
  // The course is known well enough to say what is in which lane.
  for (const double station : {15.0, 40.0, 70.0, 110.0}) {
    SparseRow row;
    state.add_lateral(row, state.axis().at(station));
    numbers.update(row, 0, 0.01);
  }
  state.rebuild_axis();
  return state;
}

Eigen::VectorXd mean_of(const RoadState& state) {
  Eigen::VectorXd mean(state.numbers().size());
  for (int i = 0; i < mean.size(); ++i) mean[i] = state.numbers().mean(i);
  return mean;
}

RoadState moved(const RoadState& state, int number, double by) {
  RoadState result = state;
  result.numbers().set_mean(number, state.numbers().mean(number) + by);
  result.rebuild_axis();
  return result;
}

Eigen::VectorXd gradient(const RoadState& state, const Residual& residual) {
  Eigen::VectorXd result(state.numbers().size());
  for (int i = 0; i < result.size(); ++i) {
    const double by = 1e-3 * std::sqrt(state.numbers().variance(i));
    result[i] = (residual(moved(state, i, by)) - residual(moved(state, i, -by))) / (2 * by);
  }
  return result;
}

/// The share of `change` that is not the covariance times some mix of these gradients, each number in its
/// sigmas.
double unexplained(const RoadState& before, const Eigen::VectorXd& change, const Eigen::MatrixXd& gradients) {
  const auto size = change.size();
  Eigen::MatrixXd covariance(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) covariance(i, j) = before.numbers().covariance(i, j);
  }
  const Eigen::VectorXd sigmas = covariance.diagonal().cwiseSqrt();
  const Eigen::VectorXd wanted = change.cwiseQuotient(sigmas);
  const Eigen::MatrixXd can = sigmas.cwiseInverse().asDiagonal() * (covariance * gradients);
  const Eigen::VectorXd rest = wanted - can * can.colPivHouseholderQr().solve(wanted);
  return rest.norm() / wanted.norm();
}

/// Small angles for sines and the lever of a bend for that of a straight road: so exact must a row be.
constexpr double kExact = 0.02;

const Pose2 kMoved{-1.1, 0.02, -0.004};

TEST(Jacobian, OfCorrectedPaint) {
  const RoadState state = any_state();
  for (const double range : {8.0, 30.0, 70.0, 110.0}) {
    const Eigen::Vector2d seen(range, 2.5);
    const SeenPaint paint = corrected(seen, kMoved, state);
    const auto by = [&](int number, double step) -> Eigen::Vector2d {
      return (corrected(seen, kMoved, moved(state, number, step)).point -
              corrected(seen, kMoved, moved(state, number, -step)).point) /
             (2 * step);
    };
    EXPECT_LT((by(kPaintPitch, 1e-7) - paint.by_pitch).norm(), 1e-4 * paint.by_pitch.norm());
    EXPECT_LT((by(kPaintYaw, 1e-6) - paint.by_turn).norm(), 1e-4 * paint.by_turn.norm());
    EXPECT_LT((by(kPaintLean, 1e-6) - paint.by_turn).norm(), 1e-4 * paint.by_turn.norm());
    for (int k = 0; k < RoadState::kOffsets; ++k) {
      SparseRow row;
      state.add_relative_height(row, range, 1);
      double lever = 0;
      for (const auto& [index, value] : row) lever += index == kCrests + k ? value : 0;
      const Eigen::Vector2d expected = paint.by_height * lever;
      EXPECT_LT((by(kCrests + k, 1e-8) - expected).norm(), 1e-4 * expected.norm() + 1e-3) << k;
    }
  }
}

TEST(Jacobian, OfAPlaceBesideTheAxis) {
  const RoadState state = any_state();
  for (const double x : {5.0, 40.0, 80.0, 120.0}) {
    const Eigen::Vector2d point(x, 3);
    const RoadAxis::Foot foot = state.axis().project(point);
    SparseRow row;
    state.add_lateral(row, foot.place, 2);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(state.numbers().size());
    for (const auto& [index, value] : row) expected[index] += value / 2;
    const Eigen::VectorXd found =
        gradient(state, [&](const RoadState& s) { return s.axis().project(point).lateral; });
    for (int i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], kExact * std::abs(expected[i]) + 0.1 + 1e-3 * x * x)
          << i << " at " << x;
    }
  }
}

TEST(Jacobian, OfALinesOffset) {
  const RoadState state = any_state();
  for (const double station : {-10.0, 5.0, 77.0, 140.0, 300.0}) {
    SparseRow row;
    state.add_offset(row, state.lines()[1], station, -0.5);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(state.numbers().size());
    for (const auto& [index, value] : row) expected[index] += value;
    const Eigen::VectorXd found =
        gradient(state, [&](const RoadState& s) { return -0.5 * s.offset(s.lines()[1], station); });
    EXPECT_LT((found - expected).norm(), 1e-9) << station;
  }
}

class PaintJacobian : public ::testing::TestWithParam<double> {};

TEST_P(PaintJacobian, IsTheGradientOfHowFarThePaintIsFromItsLine) {
  const RoadState state = any_state();
  Eigen::Vector2d seen(GetParam(), -1);
  const Residual left_of_line = [&](const RoadState& s) {
    const RoadAxis::Foot foot = s.axis().project(corrected(seen, kMoved, s).point);
    return foot.lateral - s.offset(s.lines()[1], foot.place.station);
  };
  // Paint a little beside where the line is thought to be.
  for (int i = 0; i < 20; ++i) seen.y() -= left_of_line(state) - 0.02;
  FeatureSet set;
  set.features.push_back(testing::NoiselessDrive::feature({seen.x(), seen.y(), 0}));
  RoadState after = state;
  PaintUpdate paint{RoadConfig{}};
  ASSERT_EQ(paint.take(set, kMoved, 1.2, after), 1U);
  const Eigen::VectorXd change = mean_of(after) - mean_of(state);
  EXPECT_LT(unexplained(state, change, gradient(state, left_of_line)), kExact);
  EXPECT_LT(std::abs(left_of_line(moved(after, 0, 0))), 0.02) << "and it comes nearer";
}

INSTANTIATE_TEST_SUITE_P(Ranges, PaintJacobian, ::testing::Values(8.0, 35.0, 70.0, 120.0));

class VehicleJacobian : public ::testing::TestWithParam<double> {};

TEST_P(VehicleJacobian, IsTheGradientOfHowFarItIsFromItsLanesMiddle) {
  RoadState state = any_state();
  const double range = GetParam();
  // The middle of the lane, a little to the left.
  const RoadAxis::Place place = state.axis().at(range);
  const double lane = (state.offset(state.lines()[0], range) + state.offset(state.lines()[1], range)) / 2;
  const Eigen::Vector2d middle = place.point + (lane + 0.1) * place.normal();
  FeatureSet set;
  set.lane_width = LaneWidth{3.6, 0.1};
  set.measured_at = from_nanoseconds(1'000'000'000);
  for (const Side side : {Side::left, Side::right}) {
    const double aside = side == Side::left ? 1.8 : -1.8;
    Feature& feature =
        set.features.emplace_back(testing::NoiselessDrive::feature({middle.x(), middle.y() + aside, 0}));
    feature.track_id = 4;
    feature.side = side;
  }
  VehicleUpdate vehicles{RoadConfig{}};
  ASSERT_EQ(vehicles.take(set, {}, state), 1U) << "it gets a number of its own";
  state.rebuild_axis();
  const Residual left_of_middle = [&](const RoadState& s) {
    const RoadAxis::Foot foot = s.axis().project(middle);
    const double at = foot.place.station;
    return foot.lateral - (s.offset(s.lines()[0], at) + s.offset(s.lines()[1], at)) / 2 -
           s.numbers().mean(s.vehicles()[0].index) - middle.norm() * s.numbers().mean(kVehicleYaw);
  };
  RoadState after = state;
  set.measured_at += std::chrono::milliseconds(80);
  ASSERT_EQ(vehicles.take(set, {}, after), 1U);
  const Eigen::VectorXd change = mean_of(after) - mean_of(state);
  EXPECT_LT(unexplained(state, change, gradient(state, left_of_middle)), kExact);
  EXPECT_LT(std::abs(left_of_middle(moved(after, 0, 0))), std::abs(left_of_middle(state)));
}

INSTANTIATE_TEST_SUITE_P(Ranges, VehicleJacobian, ::testing::Values(15.0, 45.0, 70.0));

/// Of both sides, or of the left one alone.
class TrackedLaneJacobian : public ::testing::TestWithParam<bool> {};

TEST_P(TrackedLaneJacobian, IsTheGradientsOfItsCourseAndItsWidth) {
  const bool both = GetParam();
  const RoadState state = any_state();
  FeatureSet set;
  for (const std::size_t i : {0U, 1U}) {
    ClothoidMeasurement side;
    const double yaw = state.numbers().mean(kTrackedYaw);
    side.clothoid = {state.offset(state.lines()[i], 0) + 0.01, yaw - state.numbers().mean(kHeading) + 4e-4,
                     5.3e-4, 2e-7};
    side.covariance = Eigen::Vector4d(0.02, 0.002, 1e-4, 1e-6).cwiseAbs2().asDiagonal();
    side.range_end = 60;
    side.side = i == 0 ? Side::left : Side::right;
    if (both || i == 0) set.clothoids.push_back(side);
  }
  Eigen::MatrixXd gradients(state.numbers().size(), 5);
  for (int i = 0; i < 4; ++i) {
    const double at = std::array{2.0, 20.0, 40.0, 60.0}[static_cast<std::size_t>(i)];
    gradients.col(i) = gradient(state, [&](const RoadState& s) {
      double y = set.clothoids[0].clothoid.y(at);
      if (both) y = (y + set.clothoids[1].clothoid.y(at)) / 2;
      const Eigen::Vector2d seen = rotation(-s.numbers().mean(kTrackedYaw)) * Eigen::Vector2d(at, y);
      const RoadAxis::Foot foot = s.axis().project(seen);
      const double left = s.offset(s.lines()[0], foot.place.station);
      const double right = s.offset(s.lines()[1], foot.place.station);
      return foot.lateral - (both ? (left + right) / 2 : left);
    });
  }
  gradients.col(4) = gradient(
      state, [](const RoadState& s) { return s.offset(s.lines()[0], 0) - s.offset(s.lines()[1], 0); });
  if (!both) gradients.conservativeResize(Eigen::NoChange, 4);
  RoadState after = state;
  TrackedLaneUpdate tracked{RoadConfig{}};
  ASSERT_EQ(tracked.take(set, {}, 1.2, after), both ? 2U : 1U);
  const Eigen::VectorXd change = mean_of(after) - mean_of(state);
  EXPECT_GT(change.norm(), 0);
  EXPECT_LT(unexplained(state, change, gradients), kExact);
}

INSTANTIATE_TEST_SUITE_P(Sides, TrackedLaneJacobian, ::testing::Bool());

}  // namespace
}  // namespace lanefuse
