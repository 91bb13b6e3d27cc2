// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "objects/object_tracker_config.hpp"
#include "objects/sighting.hpp"

namespace lanefuse {

/// Puts the reflections of one look that no track has taken and that come from one vehicle together: linked
/// to each other by what lies within a vehicle's size and goes as fast. A camera's boxes stand alone.
class SightingClusters {
 public:
  /// `track_of` each sighting: those count for which it is Assignment::kAlone.
  void find(const SightingSet& look, std::span<const int> track_of, const ObjectTrackerConfig& config);

  [[nodiscard]] int count() const { return count_; }
  /// The sightings of a cluster, by their places in the look; the nearest first.
  [[nodiscard]] std::span<const int> members(int cluster) const;

 private:
  std::vector<int> cluster_of_;
  std::vector<int> members_;
  std::vector<int> begin_;
  int count_ = 0;

  void link(const SightingSet& look, const ObjectTrackerConfig& config);
  void sort(const SightingSet& look);
};

}  // namespace lanefuse
