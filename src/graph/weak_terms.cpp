// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/weak_terms.hpp"

#include <algorithm>

namespace lanefuse {

namespace {

/// Of a term's information, what it counts for: as little as this, and the equations do without; as much, and
/// they take it back.
constexpr double kLight = 1e-7;
constexpr double kHeavy = 1e-6;

bool joins_poses(const EdgeTerms::Term& term, const EliminationOrder& order) {
  const auto is_pose = [&](VertexId v) {
    return order.block(v) != kHeld && order.block(v) >= order.landmarks();
  };
  return is_pose(term.from) && is_pose(term.to);
}

}  // namespace

bool WeakTerms::update(const EdgeTerms& terms, const EliminationOrder& order) {
  const auto& all = terms.terms();
  std::size_t light = 0, heavy = 0, left_out = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].switch_index == kNoSwitch) continue;
    const double weight = terms.weight(all[i]);
    if (joins_nothing(i)) {
      ++left_out;
      heavy += weight > kHeavy ? 1 : 0;
    } else {
      light += weight < kLight && joins_poses(all[i], order) ? 1 : 0;
    }
  }
  if (heavy == 0 && light <= left_out / 20) return false;
  joins_nothing_.resize(all.size(), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].switch_index == kNoSwitch || !joins_poses(all[i], order)) continue;
    joins_nothing_[i] = terms.weight(all[i]) < (joins_nothing_[i] != 0 ? kHeavy : kLight) ? 1 : 0;
  }
  return true;
}

}  // namespace lanefuse
