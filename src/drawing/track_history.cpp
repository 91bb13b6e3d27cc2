// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/track_history.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

TrackRole role_of(const TrackedObject& object) {
  if (object.witness) return TrackRole::witness;
  const bool stands =
      object.movement == MovementState::stationary || object.movement == MovementState::stopped;
  return stands ? TrackRole::standing : TrackRole::driving;
}

}  // namespace

bool TrackedLife::was(TrackRole role) const {
  return std::any_of(moments.begin(), moments.end(), [&](const TrackMoment& m) { return m.role == role; });
}

void TrackHistory::add(double seconds, std::span<const TrackedObject> objects) {
  duration_ = std::max(duration_, seconds);
  for (const TrackedObject& object : objects) {
    if (!std::isfinite(object.x) || !std::isfinite(object.y)) continue;
    TrackedLife& life = lives_[object.id];
    life.id = object.id;
    life.moments.push_back({seconds, object.x, object.y, role_of(object)});
  }
}

std::vector<TrackedLife> TrackHistory::lives() const {
  std::vector<TrackedLife> result;
  for (const auto& [id, life] : lives_) result.push_back(life);
  std::stable_sort(result.begin(), result.end(), [](const TrackedLife& a, const TrackedLife& b) {
    return a.moments.front().seconds < b.moments.front().seconds;
  });
  return result;
}

}  // namespace lanefuse
