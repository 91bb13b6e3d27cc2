// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/bearing_offsets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::size_t kNoOffset = 14;  ///< the bin in the middle

}  // namespace

void BearingOffsets::add(double offset) {
  const double degrees = offset / kDegree;
  if (!(std::abs(degrees) < kReach)) return;
  counts_[static_cast<std::size_t>(std::lround(degrees + kNoOffset))] += 1;
}

void BearingOffsets::forget(double keep) {
  for (double& count : counts_) count *= keep;
}

double BearingOffsets::around(std::size_t bin) const {
  const std::size_t first = bin == 0 ? 0 : bin - 1;
  const std::size_t last = std::min(bin + 1, kBins - 1);
  double sum = 0;
  for (std::size_t i = first; i <= last; ++i) sum += counts_[i];
  return sum;
}

std::size_t BearingOffsets::peak() const {
  std::size_t best = kNoOffset;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    if (around(bin) > around(best)) best = bin;
  }
  return best;
}

std::optional<double> BearingOffsets::turned(double enough, double ratio, double turned) const {
  const std::size_t at = peak();
  const double offset = (static_cast<double>(at) - kNoOffset) * kDegree;
  if (std::abs(offset) < turned || around(at) < enough || around(at) <= ratio * around(kNoOffset)) return {};
  return offset;
}

bool BearingOffsets::straight(double enough) const {
  constexpr std::size_t kNear = 2;
  const std::size_t at = peak();
  return around(at) >= enough && at + kNear >= kNoOffset && at <= kNoOffset + kNear;
}

}  // namespace lanefuse
