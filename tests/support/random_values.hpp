// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <rapidcheck.h>

#include "core/pose2.hpp"

namespace lanefuse::testing {

/// An evenly drawn number of [low, high]: what rapidcheck's own doubles, which love extremes, are not meant
/// for.
inline rc::Gen<double> between(double low, double high) {
  constexpr int kSteps = 1'000'000;
  return rc::gen::map(rc::gen::resize(100, rc::gen::inRange(0, kSteps + 1)),
                      [=](int step) { return low + (high - low) * step / kSteps; });
}

inline Pose2 any_pose(double reach = 100) {
  return {*between(-reach, reach), *between(-reach, reach), *between(-3.14159, 3.14159)};
}

/// A positive definite matrix: A A' with something on the diagonal.
template <int N>
Eigen::Matrix<double, N, N> any_covariance() {
  Eigen::Matrix<double, N, N> root;
  for (double& entry : root.reshaped()) entry = *between(-1, 1);
  return root * root.transpose() + 1e-3 * Eigen::Matrix<double, N, N>::Identity();
}

}  // namespace lanefuse::testing
