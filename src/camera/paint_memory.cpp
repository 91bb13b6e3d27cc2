// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/paint_memory.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {

void PaintMemory::move(double way) {
  rest_ = std::min(rest_ + std::max(0.0, way), static_cast<double>(kBins));
  while (rest_ >= 1) {
    rest_ -= 1;
    newest_ = (newest_ + 1) % kBins;
    stretches_[static_cast<std::size_t>(newest_)] = {};
  }
}

void PaintMemory::look(double distance, bool found) {
  const int ahead = static_cast<int>(std::floor(distance + rest_));
  if (ahead < 0 || ahead >= kAhead) return;
  Stretch& stretch = stretches_[static_cast<std::size_t>((newest_ - (kAhead - 1 - ahead) + kBins) % kBins)];
  stretch.looks += 1;
  stretch.hits += found ? 1 : 0;
}

void PaintMemory::note(bool yellow, std::optional<double> width) {
  constexpr double kSlow = 100;  // bars: a few images
  seen_ = std::min(seen_ + 1, kSlow);
  yellow_ += ((yellow ? 1 : 0) - yellow_) / seen_;
  if (!width) return;
  width_seen_ = std::min(width_seen_ + 1, kSlow);
  width_ += (*width - width_) / width_seen_;
}

std::optional<double> PaintMemory::painted() const {
  double looked = 0;
  double painted = 0;
  for (const Stretch& stretch : stretches_) {
    if (stretch.looks < 2) continue;
    looked += 1;
    painted += stretch.hits > 0.5F * stretch.looks ? 1 : 0;
  }
  constexpr double kEnough = 25;  // [m]
  if (looked < kEnough) return {};
  return painted / looked;
}

MarkingEvidence PaintMemory::evidence() const {
  MarkingEvidence evidence;
  if (const auto part = painted()) {
    if (*part > 0.75) evidence.type = MarkingType::solid;
    if (*part > 0.1 && *part < 0.62) evidence.type = MarkingType::dashed;
  }
  constexpr double kEnoughBars = 20;
  if (seen_ >= kEnoughBars) {
    if (yellow_ > 0.7) evidence.colour = MarkingColour::yellow;
    if (yellow_ < 0.3) evidence.colour = MarkingColour::white;
  }
  return evidence;
}

std::optional<double> PaintMemory::width() const {
  constexpr double kEnoughBars = 8;
  if (width_seen_ < kEnoughBars) return {};
  return width_;
}

}  // namespace lanefuse
