// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/kalman.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/random_values.hpp"

namespace lanefuse {
namespace {

using testing::any_covariance;
using testing::between;
using Scalar = Eigen::Matrix<double, 1, 1>;

Gaussian<1> scalar(double mean, double variance) { return {Scalar(mean), Scalar(variance)}; }

TEST(Kalman, WeighsTwoScalarsByTheirVariances) {
  Gaussian<1> state = scalar(10, 4);
  update<1, 1>(state, Scalar(14 - 10), Scalar(1), Scalar(4));
  EXPECT_DOUBLE_EQ(state.mean[0], 12);
  EXPECT_DOUBLE_EQ(state.covariance(0, 0), 2);
  update<1, 1>(state, Scalar(15 - 12), Scalar(1), Scalar(1));
  EXPECT_DOUBLE_EQ(state.mean[0], 14);
  EXPECT_DOUBLE_EQ(state.covariance(0, 0), 2.0 / 3);
}

TEST(Kalman, PredictsMeanAndSpread) {
  Gaussian<2> state;
  state.mean << 1, 2;
  Eigen::Matrix2d transition;
  transition << 1, 0.5, 0, 1;
  predict<2>(state, transition, Eigen::Vector2d(0.1, 0.2).asDiagonal().toDenseMatrix());
  EXPECT_DOUBLE_EQ(state.mean[0], 2);
  EXPECT_DOUBLE_EQ(state.mean[1], 2);
  EXPECT_DOUBLE_EQ(state.covariance(0, 0), 1.25 + 0.1);
  EXPECT_DOUBLE_EQ(state.covariance(0, 1), 0.5);
  EXPECT_DOUBLE_EQ(state.covariance(1, 1), 1.2);
}

TEST(Kalman, AMeasuredSpeedMovesThePositionThatHangsOnIt) {
  Gaussian<2> state;
  state.covariance << 2, 1, 1, 1;
  update<2, 1>(state, Scalar(2), Eigen::RowVector2d(0, 1), Scalar(1));
  EXPECT_DOUBLE_EQ(state.mean[0], 1);
  EXPECT_DOUBLE_EQ(state.mean[1], 1);
  EXPECT_DOUBLE_EQ(state.covariance(0, 0), 1.5);
}

TEST(Innovation, CountsInSigmas) {
  const Innovation<1> one = innovation<1, 1>(scalar(0, 3), Scalar(6), Scalar(1), Scalar(1));
  EXPECT_DOUBLE_EQ(one.covariance(0, 0), 4);
  EXPECT_DOUBLE_EQ(one.distance_squared(), 9);
  const Innovation<2> two{Eigen::Vector2d(2, 3), Eigen::Vector2d(4, 9).asDiagonal()};
  EXPECT_DOUBLE_EQ(two.distance_squared(), 2);
}

RC_GTEST_PROP(Kalman, StaysSymmetricAndPositiveOverAnySequence, ()) {
  Gaussian<3> state{Eigen::Vector3d::Zero(), 100 * Eigen::Matrix3d::Identity()};
  for (int i = 0; i < 50; ++i) {
    Eigen::Matrix3d transition = Eigen::Matrix3d::Identity();
    transition(0, 1) = *between(-1, 1);
    predict<3>(state, transition, 1e-4 * any_covariance<3>());
    const Eigen::RowVector3d jacobian(*between(-1, 1), *between(-1, 1), *between(-1, 1));
    const double before = state.covariance.trace();
    update<3, 1>(state, Scalar(*between(-10, 10)), jacobian, Scalar(*rc::gen::element(1e-4, 1e-2, 1.0)));
    const double asymmetry = (state.covariance - state.covariance.transpose()).cwiseAbs().maxCoeff();
    RC_ASSERT(asymmetry <= 1e-9 * state.covariance.cwiseAbs().maxCoeff());
    RC_ASSERT(state.covariance.diagonal().minCoeff() > 0);
    RC_ASSERT(state.covariance.trace() <= before * (1 + 1e-9));
    RC_ASSERT(state.covariance.llt().info() == Eigen::Success);
  }
}

RC_GTEST_PROP(Kalman, TheOrderOfIndependentMeasurementsDoesNotMatter, ()) {
  Gaussian<2> one{Eigen::Vector2d(*between(-5, 5), *between(-5, 5)), any_covariance<2>()};
  Gaussian<2> other = one;
  const Eigen::RowVector2d first(*between(-1, 1), *between(-1, 1));
  const Eigen::RowVector2d second(*between(-1, 1), *between(-1, 1));
  const auto measure = [](Gaussian<2>& state, const Eigen::RowVector2d& jacobian, double value) {
    update<2, 1>(state, Scalar(value - jacobian * state.mean), jacobian, Scalar(0.5));
  };
  measure(one, first, 3);
  measure(one, second, -1);
  measure(other, second, -1);
  measure(other, first, 3);
  RC_ASSERT((one.mean - other.mean).norm() < 1e-9);
  RC_ASSERT((one.covariance - other.covariance).norm() < 1e-9);
}

}  // namespace
}  // namespace lanefuse
