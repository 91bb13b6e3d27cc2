// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/determinacy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lanefuse {

namespace {

constexpr double kLeastPivotShare = 1e-13;

}  // namespace

bool is_determined(const Eigen::Matrix3d& remaining, const Eigen::Vector3d& diagonal) {
  const double of_position = std::sqrt(std::max(diagonal[0], diagonal[1]));
  const Eigen::Vector3d scale(of_position, of_position, std::sqrt(diagonal[2]));
  if (!(scale.minCoeff() > 0)) return false;
  const Eigen::Vector3d unit = scale.cwiseInverse();
  Eigen::Matrix3d block = unit.asDiagonal() * remaining * unit.asDiagonal();
  std::array<int, 3> order{0, 1, 2};
  for (int k = 0; k < 3; ++k) {
    for (int i = k + 1; i < 3; ++i) {
      if (block(order[i], order[i]) > block(order[k], order[k])) std::swap(order[i], order[k]);
    }
    const double pivot = block(order[k], order[k]);
    if (!(pivot > kLeastPivotShare)) return false;
    for (int i = k + 1; i < 3; ++i) {
      const double share = block(order[i], order[k]) / pivot;
      for (int j = k + 1; j < 3; ++j) block(order[i], order[j]) -= share * block(order[k], order[j]);
    }
  }
  return true;
}

}  // namespace lanefuse
