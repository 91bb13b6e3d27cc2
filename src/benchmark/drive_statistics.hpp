// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace lanefuse {

/// One drive's word on a figure, and how many judgements are behind it. Drives are the independent units:
/// cycles within one are not.
struct DriveSample {
  double value = 0;
  double weight = 1;  ///< above zero
};

/// A mean over drives with its 95 % confidence interval.
struct MeanOfDrives {
  double mean = 0;
  std::optional<double> half_width;  ///< nothing from fewer than two drives
  std::size_t drives = 0;
};

/// The weighted mean, so that equal weights give each drive the same say, and numbers of deviations give the
/// mean over all deviations. Its interval is Student's t over the drives (of a ratio of two means, where the
/// weights differ). Nothing where there is no drive.
std::optional<MeanOfDrives> mean_of_drives(std::span<const DriveSample> samples);

/// One drive's word on two figures, or on one figure of two systems.
struct PairedSample {
  DriveSample over;
  DriveSample under;
};

/// A ratio of two means over the same drives. Its 95 % confidence interval is [ratio / factor, ratio *
/// factor].
struct RatioOfMeans {
  double ratio = 0;
  std::optional<double> factor;  ///< at least 1; nothing from fewer than two drives
};

/// The ratio of the weighted means. Its interval is Student's t over the drives, of the ratio's logarithm to
/// first order, so that what the two sides of a drive share is gone. Nothing where there is no drive, or
/// where a mean is not above zero.
std::optional<RatioOfMeans> ratio_of_means(std::span<const PairedSample> samples);

/// How much larger a figure is on one side than on the other.
struct Difference {
  double mean = 0;
  std::optional<double> half_width;   ///< of the 95 % confidence interval, this figure alone
  std::optional<double> probability;  ///< of so large a difference where there is none; as half_width
};

/// From differences of pairs: what the two sides of a pair share is gone. Needs at least one.
Difference paired_difference(std::span<const double> differences);

/// Of two sides that share nothing, b minus a, each with a variance of its own (Welch). Needs one value each.
Difference unpaired_difference(std::span<const double> a, std::span<const double> b);

}  // namespace lanefuse
