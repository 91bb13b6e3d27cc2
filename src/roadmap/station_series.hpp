// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace lanefuse {

/// A number at every station of a survey; what is not known is not a number.
using StationSeries = std::vector<double>;

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
inline bool is_known(double value) { return !std::isnan(value); }

/// The mean of what is known within `reach` stations to either side.
StationSeries box_mean(const StationSeries& series, std::size_t reach);

/// The parabola of least squares through what is known within `reach` stations to either side, at its middle;
/// unknown where there is too little around for one.
StationSeries smoothed(const StationSeries& series, std::size_t reach);

/// Joins what is known by straight lines over at most `longest` unknown stations.
void fill_gaps(StationSeries& series, std::size_t longest);

/// The mean of all that is known; unknown where there is nothing.
double mean_of(const StationSeries& series);

/// The mean of a - b where both are known, and at how many stations.
struct MeanDifference {
  double mean = kUnknown;
  std::size_t count = 0;
};
MeanDifference mean_difference(const StationSeries& a, const StationSeries& b);

/// A mean that an outlier does not drag along: Huber's weights around the median, from three values on.
double robust_mean(std::vector<double>& values, double inlier);

}  // namespace lanefuse
