// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/true_lines.hpp"

#include <algorithm>

namespace lanefuse {

std::optional<TrueLine::Place> TrueLine::at(double x) const {
  const auto beyond =
      std::find_if(points.begin(), points.end(), [x](const auto& point) { return point.x() >= x; });
  if (beyond == points.begin() || beyond == points.end()) return {};
  const Eigen::Vector2d& a = *std::prev(beyond);
  const Eigen::Vector2d step = *beyond - a;
  if (!(step.x() > 0)) return {};
  const double slope = step.y() / step.x();
  return Place{a.y() + slope * (x - a.x()), slope};
}

}  // namespace lanefuse
