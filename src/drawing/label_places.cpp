// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/label_places.hpp"

#include <algorithm>
#include <array>

namespace lanefuse {
namespace {

constexpr double kHeight = 13;
constexpr double kCharacter = 6.1;  // mean width at the size of ticks
constexpr double kAway = 3;         // from the line

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

bool contains(const Box& box, const Pixel& p) {
  return p.x() > box.left && p.x() < box.right() && p.y() > box.top && p.y() < box.bottom();
}

}  // namespace

void LabelPlaces::occupy(const std::vector<Pixel>& line) {
  lines_.insert(lines_.end(), line.begin(), line.end());
}

/// How many points it would hide; none where it may not stand.
std::optional<std::size_t> LabelPlaces::cost(const Box& place) const {
  const bool inside = place.left >= frame_.left && place.right() <= frame_.right() &&
                      place.top >= frame_.top && place.bottom() <= frame_.bottom();
  const bool taken =
      std::any_of(labels_.begin(), labels_.end(), [&](const Box& label) { return overlap(label, place); });
  if (!inside || taken) return {};
  const auto hidden =
      std::count_if(lines_.begin(), lines_.end(), [&](const Pixel& p) { return contains(place, p); });
  return static_cast<std::size_t>(hidden);
}

std::optional<Box> LabelPlaces::beside(const std::vector<Pixel>& line, std::string_view text) {
  if (line.empty()) return {};
  const double width = kCharacter * static_cast<double>(text.size()) + 4;
  std::optional<Box> best;
  std::size_t least = 0;
  for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9, 0.0, 1.0}) {
    const Pixel& at = line[static_cast<std::size_t>(share * static_cast<double>(line.size() - 1))];
    for (const double top : {at.y() - kAway - kHeight, at.y() + kAway}) {
      for (const double left : {at.x() - width / 2, at.x() + kAway, at.x() - width - kAway}) {
        const Box place{left, top, width, kHeight};
        const auto hidden = cost(place);
        if (!hidden || (best && *hidden >= least)) continue;
        best = place;
        least = *hidden;
      }
    }
  }
  if (best) labels_.push_back(*best);
  return best;
}

}  // namespace lanefuse
