// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/motion.hpp"
#include "graph/solver.hpp"

namespace lanefuse {

/// When a measured feature is taken for one that the window already holds. The gates are in the feature's own
/// frame.
struct AssociationConfig {
  double along = 1.2;               ///< [m] along the feature's heading
  double across = 0.6;              ///< [m] across it, at the car
  double across_per_metre = 0.004;  ///< [m/m] more across, the further ahead
  double heading_deg = 6;           ///< [deg] plus twice the measured sigma
};

/// The constraints of [IROS16, sec. II-E] and how strong they are.
struct FusionConfig {
  double keyframe_distance = 2;  ///< [m] driven between two poses of the window
  double drop_behind = 5;        ///< [m] features further behind are forgotten [IROS16, sec. II-E1]
  double drop_beyond = 160;      ///< [m] ahead: no sensor reaches further, what is there has diverged
  double drop_lateral = 60;      ///< [m] to either side
  double drop_age_s = 60;        ///< [s] since a feature was last measured
  double sample_spacing = 2;  ///< [m] between the samples of a serial camera's clothoid [IROS16, sec. II-E2]
  double sigma_along = 1;     ///< [m] along a marking nothing tells features apart: more would drag the poses
  double confidence_gain = 0.3;  ///< share of a measurement's confidence that a fused feature takes over
  double smoothing_sigma = 0.1;  ///< [m] between a track's successive features
  double smoothing_heading_deg = 0.5;
  double width_sigma = 0.1;  ///< [m] on top of the lane width's own uncertainty
  double width_heading_deg = 0.5;
  double switch_prior = 4;  ///< Omega_s: the squared error above which a smoothing edge starts to switch off
  bool width_edges = true;
  bool smoothing_edges = true;
  bool switchable = true;  ///< whether smoothing edges carry a switch variable
  /// Bounds of the window's memory. When one is nearly met, the least informative features are forgotten and
  /// counted; what still does not fit in a cycle is counted as dropped.
  std::uint32_t max_features = 4096;
  std::uint32_t max_measurements = 65536;
  std::uint32_t max_ties = 16384;
  AssociationConfig association;
  OdometryNoise odometry;
  SolverConfig solver;
};

}  // namespace lanefuse
