// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/magnitude_histogram.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace lanefuse {
namespace {

constexpr double kSmallest = 1e-3;  // [m] all below shares the first bin
constexpr double kGrowth = 1.01;
constexpr std::size_t kBins = 1160;  // to 100 m; all beyond shares the last bin

std::size_t bin_of(double magnitude) {
  if (magnitude <= kSmallest) return 0;
  const double steps = std::log(magnitude / kSmallest) / std::log(kGrowth);
  return static_cast<std::size_t>(std::min(1.0 + steps, static_cast<double>(kBins - 1)));
}

double middle_of(std::size_t bin) {
  return bin == 0 ? 0.0 : kSmallest * std::pow(kGrowth, static_cast<double>(bin) - 0.5);
}

}  // namespace

void MagnitudeHistogram::add(double magnitude) {
  assert(magnitude >= 0);
  if (bins_.empty()) bins_.resize(kBins);
  ++bins_[bin_of(magnitude)];
  smallest_ = count_ == 0 ? magnitude : std::min(smallest_, magnitude);
  largest_ = std::max(largest_, magnitude);
  ++count_;
}

void MagnitudeHistogram::merge(const MagnitudeHistogram& other) {
  if (other.count_ == 0) return;
  if (count_ == 0) {
    *this = other;
    return;
  }
  std::transform(bins_.begin(), bins_.end(), other.bins_.begin(), bins_.begin(), std::plus<>());
  smallest_ = std::min(smallest_, other.smallest_);
  largest_ = std::max(largest_, other.largest_);
  count_ += other.count_;
}

double MagnitudeHistogram::quantile(double share) const {
  if (count_ == 0) return std::numeric_limits<double>::quiet_NaN();
  const double rank = std::ceil(share * static_cast<double>(count_));
  std::size_t bin = 0;
  for (std::uint64_t below = bins_[0]; static_cast<double>(below) < rank && bin + 1 < kBins;
       below += bins_[bin])
    ++bin;
  return std::clamp(middle_of(bin), smallest_, largest_);
}

}  // namespace lanefuse
