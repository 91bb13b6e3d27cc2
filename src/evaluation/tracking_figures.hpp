// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "evaluation/magnitude_histogram.hpp"

namespace lanefuse {

/// Tracks against true vehicles within some range, frame by frame [CLEAR MOT: Bernardin and Stiefelhagen,
/// 2008; IDF1: Ristani et al., 2016]. Ratios are NaN where there was nothing to count.
struct TrackingCounts {
  std::uint64_t vehicles = 0;      ///< true vehicles to be tracked, summed over the frames
  std::uint64_t hits = 0;          ///< of those, with a track on them
  std::uint64_t false_tracks = 0;  ///< tracks on no vehicle, summed over the frames
  std::uint64_t id_switches = 0;   ///< times that a vehicle's track got another id
  std::uint64_t id_hits = 0;       ///< hits, were each vehicle given one track for the whole drive
  double vehicle_hours = 0;        ///< [h] that `vehicles` make

  TrackingCounts& operator+=(const TrackingCounts& other);
  [[nodiscard]] double mota() const;
  [[nodiscard]] double idf1() const;
  [[nodiscard]] double recall() const;
  [[nodiscard]] double precision() const;
  [[nodiscard]] double id_switches_per_vehicle_hour() const;
};

/// Errors of the tracks on vehicles that are about equally far ahead; NaN where n is 0.
struct TrackErrors {
  std::uint64_t n = 0;
  double lateral_squares = 0;     ///< [m^2] across the true vehicle's heading
  double stated_variance = 0;     ///< [m^2] of them by the tracks themselves
  double lateral_normalised = 0;  ///< of (error / stated sigma)^2
  double heading_squares = 0;     ///< [rad^2]

  void add(double lateral, double sigma, double heading);
  TrackErrors& operator+=(const TrackErrors& other);
  [[nodiscard]] double lateral_rmse() const;    ///< [m]
  [[nodiscard]] double stated_lateral() const;  ///< [m] what it should be by the tracks' own word
  [[nodiscard]] double lateral_nees() const;    ///< 1 is honest, above is overconfident
  [[nodiscard]] double heading_rmse() const;    ///< [rad]
};

/// All that is said of a drive's tracks, as sums, so that many drives make one figure. TrackingJudge says
/// what counts.
struct TrackingFigures {
  static constexpr double kBinLength = 20;  ///< [m] ahead, of the rear
  static constexpr std::size_t kBins = 8;   ///< to 160 m

  std::uint64_t frames = 0;
  double hours = 0;           ///< [h] of driving
  std::uint64_t objects = 0;  ///< tracks handed in, summed over the frames
  TrackingCounts all;
  TrackingCounts near;    ///< only within `near_range`
  double near_range = 0;  ///< [m]

  double gospa_sum = 0;  ///< [m]
  /// What GOSPA's squares are made of [m^2]; together they are the sum of its squares.
  double localisation_sum = 0;
  double missed_sum = 0;
  double false_sum = 0;

  std::uint64_t tracks = 0;           ///< ids
  std::uint64_t false_confirmed = 0;  ///< of those, on no vehicle for more than half of their life
  std::uint64_t witnesses = 0;        ///< of those, that ever bore witness
  std::uint64_t false_witnesses = 0;  ///< of those, that ever did so where no vehicle was

  std::array<TrackErrors, kBins> ahead;
  MagnitudeHistogram confirm_s;       ///< [s] from the first sight of a vehicle to its first track
  std::uint64_t confirmed = 0;        ///< vehicles in it
  std::uint64_t never_confirmed = 0;  ///< vehicles in sight for a while that never got a track

  TrackingFigures& operator+=(const TrackingFigures& other);
  /// Whether there was anything to judge by: both true vehicles and tracks.
  [[nodiscard]] bool judged() const { return all.vehicles > 0 && objects > 0; }
  [[nodiscard]] double gospa() const;  ///< [m] mean over the frames
  [[nodiscard]] double a_frame(double sum) const;
  [[nodiscard]] double an_hour(std::uint64_t count) const;
};

}  // namespace lanefuse
