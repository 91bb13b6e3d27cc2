// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/feature.hpp"
#include "core/lane_estimate.hpp"
#include "core/pose2.hpp"
#include "lanes/base_clothoid.hpp"
#include "lanes/boundary_filter.hpp"
#include "lanes/grouping.hpp"
#include "lanes/lane_model_config.hpp"

namespace lanefuse {

/// Multi-lane modelling [IROS16, Fig. 1 and sec. II-F]: from fused features to boundaries and lanes. First
/// the road's course, then each boundary's offset, then a filter a boundary.
class LaneModel {
 public:
  /// `config` must outlive the model.
  explicit LaneModel(const LaneModelConfig& config)
      : config_(config), base_fit_(config_.base), grouping_(config_) {}

  /// Runs one cycle on F_fused in the vehicle frame; `previous_from_current` is the car's motion since the
  /// last one. Fills boundaries, lanes, status and reason of `estimate`.
  void process(std::span<const Feature> fused, const Pose2& previous_from_current, LaneEstimate& estimate);

  /// How the last cycle used its features.
  void explain(std::span<const Feature> fused, DebugView& view) const;

  void reset();

 private:
  /// Gives the road's course that the boundaries were fitted on.
  BaseClothoid fit_boundaries(std::span<const Feature> fused, const BaseClothoid& heading_fit);
  void found_boundaries(std::span<const Feature> fused, const BaseClothoid& base);
  std::optional<BoundaryFit> fit_offset(std::span<const Feature> fused, int group, const BaseClothoid& base);
  void observe(BoundaryFilter& boundary, std::span<const Feature> fused, int group) const;
  void forget_boundaries();
  void write_boundaries(LaneEstimate& estimate);
  void cut_to_range(Boundary& boundary) const;
  void count_support(std::span<const Feature> fused, LaneEstimate& estimate) const;
  void write_lanes(LaneEstimate& estimate);
  void forget_lanes(const LaneEstimate& estimate);
  std::uint64_t lane_id(std::uint64_t left, std::uint64_t right);

  const LaneModelConfig& config_;
  BaseClothoidFit base_fit_;
  Grouping grouping_;
  std::optional<BaseClothoid> base_;        ///< of the last cycle, if it had one
  std::vector<BoundaryFilter> boundaries_;  ///< from old to young
  std::vector<double> offsets_;             ///< scratch: y0 of each boundary
  std::vector<std::uint64_t> group_ids_;    ///< the boundary that each group of the last cycle stands for
  std::uint64_t next_boundary_ = 1;
  std::uint64_t next_lane_ = 1;
  struct KnownLane {
    std::uint64_t left, right;  ///< boundaries
    std::uint64_t id;
  };
  std::vector<KnownLane> known_lanes_;
  std::vector<std::pair<double, double>>
      group_offsets_;                   ///< scratch: offset and weight of a group's features
  std::vector<std::size_t> from_left_;  ///< scratch: boundaries in order across the road
  std::vector<std::vector<BoundaryPoint>> spare_points_;  ///< memory that goes from cycle to cycle
};

}  // namespace lanefuse
