// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/grouping.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace lanefuse {
namespace {

double offset_of(const Feature& feature, const Clothoid& base) { return feature.y - base.y(feature.x); }

double distance_to_nearest(double offset, std::span<const double> offsets) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double other : offsets) nearest = std::min(nearest, std::abs(offset - other));
  return nearest;
}

}  // namespace

void Grouping::assign(std::span<const Feature> features, std::span<const FitRole> roles, const Clothoid& base,
                      std::span<const double> offsets) {
  assert(roles.size() == features.size());
  groups_.assign(features.size(), -1);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (roles[i] != FitRole::inlier) continue;
    const double offset = offset_of(features[i], base);
    double nearest = config_.group_gate;
    for (std::size_t b = 0; b < offsets.size(); ++b) {
      const double distance = std::abs(offset - offsets[b]);
      if (!(distance < nearest)) continue;  // nor if it is not a number
      nearest = distance;
      groups_[i] = static_cast<int>(b);
    }
  }
}

std::span<const double> Grouping::new_offsets(std::span<const Feature> features, const Clothoid& base,
                                              std::span<const double> offsets) {
  leftovers_.clear();
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (groups_[i] < 0 && features[i].x < config_.birth_range && is_sound(features[i])) {
      leftovers_.push_back(offset_of(features[i], base));
    }
  }
  std::sort(leftovers_.begin(), leftovers_.end());
  taken_.assign(offsets.begin(), offsets.end());
  founded_.clear();
  while (true) {
    std::size_t best_count = config_.birth_features;
    double best_offset = 0;
    bool found = false;
    for (auto first = leftovers_.begin(); first != leftovers_.end(); ++first) {
      const auto last = std::upper_bound(first, leftovers_.end(), *first + config_.birth_window);
      const auto count = static_cast<std::size_t>(last - first);
      if (count < best_count + (found ? 1 : 0)) continue;
      const double mean = std::accumulate(first, last, 0.0) / static_cast<double>(count);
      if (distance_to_nearest(mean, taken_) < config_.birth_distance) continue;
      found = true;
      best_count = count;
      best_offset = mean;
    }
    if (!found) return founded_;
    taken_.push_back(best_offset);
    founded_.push_back(best_offset);
  }
}

}  // namespace lanefuse
