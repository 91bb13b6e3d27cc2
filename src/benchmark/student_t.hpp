// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace lanefuse {

/// How likely Student's t with `freedom` degrees is at least as far from zero as `t`, either way.
double two_sided_probability(double t, double freedom);

/// The t that Student's t with `freedom` degrees stays within with probability `share` in (0, 1), either way:
/// 2.571 for 0.95 and 5.
double two_sided_quantile(double share, double freedom);

/// Holm's correction: probabilities that may each be held against the level as if only one had been looked
/// at. In the order given.
std::vector<double> holm(std::span<const double> probabilities);

}  // namespace lanefuse
