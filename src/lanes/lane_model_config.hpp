// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace lanefuse {

/// From which of the fused features' numbers the road's course is fitted.
enum class BaseFit : std::uint8_t {
  heading = 0,  ///< headings only: the paper's fit
  joint = 1,    ///< headings and positions together, with one offset a boundary
};

/// The road's course [IROS16, sec. II-F].
struct BaseClothoidConfig {
  BaseFit fit = BaseFit::heading;
  double range_begin = -5;   ///< [m] features further behind do not count
  double range_end = 135;    ///< [m] features further ahead do not count
  double outlier_cut = 2.5;  ///< residuals above this times 1.4826 MAD are cut
  int max_iterations = 10;   ///< of fitting and cutting
  std::uint32_t min_features = 8;
  double curvature_sigma = 2e-3;  ///< [1/m] weak prior, a radius of 500 m: decides only where data does not
  double curvature_rate_sigma = 1e-5;  ///< [1/m^2] the same, a clothoid parameter of 316 m
  double heading_sigma_deg = 1;  ///< [deg] of one fully confident feature's heading, before the fit shows it
  double position_sigma = 0.15;  ///< [m] of one fully confident feature's position, for the joint fit
  /// Neighbouring features share their errors: in the covariance this many count as one, of paint,
  double correlation = 24;
  /// and of a vehicle's trail, whose driver errs for longer than a camera.
  double track_correlation = 60;
};

/// Grouping to boundaries, their birth and death, and their filters.
struct LaneModelConfig {
  BaseClothoidConfig base;
  double group_gate = 1.0;    ///< [m] a feature further than this from every boundary is left over
  double birth_range = 45;    ///< [m] leftovers nearer than this may found a boundary
  double birth_window = 0.5;  ///< [m] across within which they must lie
  std::uint32_t birth_features = 6;
  /// Of each of them, at least, unless a tracked vehicle witnessed it: a bar of paint that was seen two or
  /// three times may be a stretch of guard rail; a tracker has looked more often. False boundaries a frame:
  /// .3 -> .51, .5 -> .018, .7 -> .005 (6 km, nominal preset).
  double birth_confidence = 0.7;
  double birth_sigma = 0.5;         ///< [m] of the offset of a boundary just founded
  double birth_distance = 2;        ///< [m] to the nearest boundary, at least
  std::uint32_t keep_features = 3;  ///< features as good as for a birth that keep a boundary alive
  std::uint32_t max_misses = 12;    ///< cycles without them after which it is forgotten
  double merge_distance = 1.5;      ///< [m] a boundary this near to an older one is forgotten
  double lane_width_min = 2.4;      ///< [m] narrower gaps between boundaries are no lane
  double lane_width_max = 5;        ///< [m] wider ones neither
  double range_max = 150;           ///< [m] no boundary speaks further
  double sigma_max = 2;             ///< [m] nor where its lateral sigma exceeds this
  double offset_range = 40;  ///< [m] at which a feature counts half as much for the offset as beside the car
  /// Process noise of a boundary's filter, standard deviations a 2.4 m driven.
  double process_offset = 0.01;          ///< [m]
  double process_heading = 7e-4;         ///< [rad]
  double process_curvature = 4e-5;       ///< [1/m]
  double process_curvature_rate = 5e-6;  ///< [1/m^2]
  /// Measurement noise of a boundary's filter: what a fit is never better than.
  double measured_offset = 0.15;          ///< [m]
  double measured_heading = 6e-3;         ///< [rad]
  double measured_curvature = 3e-4;       ///< [1/m]
  double measured_curvature_rate = 8e-6;  ///< [1/m^2]
};

}  // namespace lanefuse
