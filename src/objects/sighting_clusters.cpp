// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/sighting_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/assignment.hpp"

namespace lanefuse {
namespace {

constexpr int kOpen = -1;   ///< in no cluster yet
constexpr int kTaken = -2;  ///< some track's

bool is_same_vehicle(const Sighting& a, const Sighting& b, const ObjectTrackerConfig& config) {
  const double turn = b.bearing - a.bearing;
  const double along = b.range * std::cos(turn) - a.range;
  const double across = b.range * std::sin(turn);
  const double doubt = 2 * std::max(a.bearing_sigma * a.range, b.bearing_sigma * b.range);
  const bool alike =
      !a.range_rate || !b.range_rate || std::abs(*a.range_rate - *b.range_rate) < config.same_range_rate;
  return alike && std::abs(along) < config.same_along && std::abs(across) < config.same_across + doubt;
}

}  // namespace

void SightingClusters::find(const SightingSet& look, std::span<const int> track_of,
                            const ObjectTrackerConfig& config) {
  cluster_of_.resize(look.sightings.size());
  for (std::size_t i = 0; i < cluster_of_.size(); ++i) {
    cluster_of_[i] = track_of[i] == Assignment::kAlone ? kOpen : kTaken;
  }
  count_ = 0;
  if (look.kind == SightingKind::camera) {
    for (int& cluster : cluster_of_) {
      if (cluster == kOpen) cluster = count_++;
    }
  } else {
    link(look, config);
  }
  sort(look);
}

/// Everything that hangs together, found by walking from one to the next.
void SightingClusters::link(const SightingSet& look, const ObjectTrackerConfig& config) {
  std::vector<int>& open = members_;
  for (std::size_t first = 0; first < cluster_of_.size(); ++first) {
    if (cluster_of_[first] != kOpen) continue;
    cluster_of_[first] = count_;
    open.assign(1, static_cast<int>(first));
    while (!open.empty()) {
      const Sighting& from = look.sightings[static_cast<std::size_t>(open.back())];
      open.pop_back();
      for (std::size_t i = first + 1; i < cluster_of_.size(); ++i) {
        if (cluster_of_[i] != kOpen || !is_same_vehicle(from, look.sightings[i], config)) continue;
        cluster_of_[i] = count_;
        open.push_back(static_cast<int>(i));
      }
    }
    ++count_;
  }
}

void SightingClusters::sort(const SightingSet& look) {
  members_.clear();
  for (std::size_t i = 0; i < cluster_of_.size(); ++i) {
    if (cluster_of_[i] != kTaken) members_.push_back(static_cast<int>(i));
  }
  std::sort(members_.begin(), members_.end(), [&](int a, int b) {
    const auto key = [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      return std::tuple(cluster_of_[at], look.sightings[at].range, i);
    };
    return key(a) < key(b);
  });
  begin_.assign(static_cast<std::size_t>(count_) + 1, 0);
  for (const int cluster : cluster_of_) {
    if (cluster != kTaken) ++begin_[static_cast<std::size_t>(cluster) + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
}

std::span<const int> SightingClusters::members(int cluster) const {
  const auto at = static_cast<std::size_t>(cluster);
  const auto begin = static_cast<std::size_t>(begin_[at]);
  return std::span(members_).subspan(begin, static_cast<std::size_t>(begin_[at + 1]) - begin);
}

}  // namespace lanefuse
