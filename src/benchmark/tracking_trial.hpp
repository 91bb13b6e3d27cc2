// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "evaluation/tracking_figures.hpp"
#include "simulation/road.hpp"
#include "sources/object_source.hpp"

namespace lanefuse {

/// A simulated drive in which only the tracking of the vehicles around is judged: dead reckoning and the
/// object source run in the pipeline's cycles, no lanes are estimated.
struct TrackingTrial {
  std::uint64_t seed = 1;
  double km = 24;
  RoadKind road = RoadKind::gentle;
  std::optional<int> guard_rail_mirrors;  ///< most ghosts beside guard rails a scan; else the preset's
  ObjectSourceConfig objects;
};

struct TrackingTrialFigures {
  TrackingFigures fused;              ///< the object source's tracks
  TrackingFigures nearest_neighbour;  ///< see NearestNeighbour
  TrackingTrialFigures& operator+=(const TrackingTrialFigures& other);
};

/// The longest drive of a trial: what is to be longer is made of several [km].
inline constexpr double kTrialKm = 24;

/// The drives that `km` of one seed are cut into; the seeds of all but the first are made from it.
std::vector<TrackingTrial> cut_trial(const TrackingTrial& whole);

/// The same trial gives the same figures. `progress` hears now and then how far it is, in [0, 1].
TrackingTrialFigures run_trial(const TrackingTrial& trial, const std::function<void(double)>& progress);

}  // namespace lanefuse
