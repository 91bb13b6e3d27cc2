// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/missing_paint.hpp"

#include <algorithm>

namespace lanefuse {
namespace {

constexpr Range kPiece{60, 300};  ///< [m] of road without paint in one go

}  // namespace

void remove_paint(RoadDraft& draft, const RoadEvent& event, Stretch stretch, Random& random) {
  const bool all = event.lines == RoadEvent::Lines::all;
  const int from_line = all ? 0 : draft.main_lanes() / 2 + 1;
  if (event.share >= 1) return draft.remove_paint(from_line, stretch);
  double station = stretch.begin;
  while (station < stretch.end) {
    const double piece = random.uniform(kPiece.low, kPiece.high);
    // Painted before and behind, so that every piece with its surroundings keeps to the share.
    const double painted = piece * (1 - event.share) / event.share;
    const double begin = station + painted * random.uniform();
    if (begin < stretch.end) draft.remove_paint(from_line, {begin, std::min(begin + piece, stretch.end)});
    station += piece + painted;
  }
}

}  // namespace lanefuse
