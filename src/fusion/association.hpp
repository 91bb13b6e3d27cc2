// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/feature.hpp"
#include "core/pose2.hpp"
#include "fusion/fusion_config.hpp"
#include "graph/window_graph.hpp"

namespace lanefuse {

/// Finds the fused feature that a measured one belongs to [IROS16, sec. II-E2: "associated with all existing
/// lane features"]. Holds the fused features of one cycle in the vehicle frame, in slices along the road.
class FeatureAssociation {
 public:
  using Id = WindowGraph::Id;

  /// Memory is set aside for `features` of them.
  FeatureAssociation(const AssociationConfig& config, std::size_t features);

  /// Starts a cycle: forgets all features.
  void clear();

  /// Adds a fused feature at `pose` in the vehicle frame of the cycle.
  void add(Id id, const Pose2& pose);

  /// The same for a feature that the current set has just created: it is not given away again in this set.
  void add_claimed(Id id, const Pose2& pose);

  /// Starts a new set of measurements: within one set, each fused feature is given away at most once.
  void begin_set();

  /// The feature within all gates with the smallest Mahalanobis distance, or nothing. Gates and distance are
  /// taken in the frame of `measured`, a pose in the vehicle frame of the cycle; `information` is the
  /// measurement's, in that frame.
  std::optional<Id> claim(const Pose2& measured, const Eigen::Matrix3d& information);

 private:
  struct Candidate {
    Id id;
    Pose2 pose;
    std::uint32_t next;  ///< of the same slice
  };
  [[nodiscard]] std::size_t slice(double x) const;
  [[nodiscard]] bool within_gates(const Pose2& offset, double x, double heading_sigma) const;

  const AssociationConfig& config_;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> slices_;      ///< the candidate that was put last into each
  std::vector<std::uint32_t> claimed_in_;  ///< by feature: the number of the set that claimed it last
  std::uint32_t set_ = 0;
};

}  // namespace lanefuse
