// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/clothoid.hpp"
#include "core/feature.hpp"
#include "lanes/base_clothoid.hpp"
#include "lanes/lane_model_config.hpp"

namespace lanefuse {

/// Sorts fused features to boundaries [IROS16, sec. II-F]. All boundaries run along the base clothoid (eq.
/// 13), so a feature belongs to the boundary whose offset is nearest to its own, y - (theta0 x + c0 x^2/2 +
/// c1 x^3/6).
class Grouping {
 public:
  explicit Grouping(const LaneModelConfig& config) : config_(config) {}

  /// Gives each feature the index of the nearest of `offsets` within the gate, or -1. Features that the base
  /// fit cut or left out stay out.
  void assign(std::span<const Feature> features, std::span<const FitRole> roles, const Clothoid& base,
              std::span<const double> offsets);

  /// Where enough leftovers in the near range lie close together across the road and far enough from every
  /// boundary: the offset of a new one. The densest place first.
  /// Valid until the next call.
  [[nodiscard]] std::span<const double> new_offsets(std::span<const Feature> features, const Clothoid& base,
                                                    std::span<const double> offsets);

  /// Whether a feature is good enough to found a boundary, or to keep one alive.
  [[nodiscard]] bool is_sound(const Feature& feature) const {
    return feature.track_id != kNoTrack || feature.confidence >= config_.birth_confidence;
  }

  /// The group of each feature of the last assign(), -1 for leftovers.
  [[nodiscard]] std::span<const int> groups() const { return groups_; }

 private:
  const LaneModelConfig& config_;
  std::vector<int> groups_;
  std::vector<double> leftovers_, taken_, founded_;
};

}  // namespace lanefuse
