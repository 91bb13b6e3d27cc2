// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/deviation.hpp"
#include "evaluation/surveyed_truth.hpp"
#include "evaluation/tracking_figures.hpp"
#include "sensors/drive.hpp"

namespace lanefuse {

/// Whether the estimate's own sigma fits its deviations: the mean of (deviation / sigma)^2. 1 is honest,
/// above is overconfident, below is timid. And whether the protection levels, the bounds that it vouches for,
/// hold.
struct ConsistencyStatistics {
  double distance_m = 0;
  double mean_normalised_square = 0;  ///< NaN where n is 0
  std::uint64_t n = 0;                ///< deviations that came with a sigma above zero
  /// Share of the deviations inside the interval that should hold 68, 95 and 99 % of them, were they normal
  /// with the stated sigma; NaN where n is 0.
  double within_68 = 0;
  double within_95 = 0;
  double within_99 = 0;
  double stated_sigma_m = 0;  ///< mean of the stated sigmas; NaN where n is 0
  /// Mean of the protection levels, and the share of the deviations beyond their own; NaN where n_protected
  /// is 0.
  double protection_m = 0;
  double misleading_rate = 0;
  std::uint64_t n_protected = 0;  ///< deviations that came with a protection level
};

/// How often the estimate reached a distance, of the cycles that are asked about.
struct AvailabilityStatistics {
  double distance_m = 0;
  double availability = 0;   ///< NaN where cycles is 0
  std::uint64_t cycles = 0;  ///< asked about, with truth at this distance
};

/// The lanes that are judged. One entry a distance; against the ego path, `ego` is the ego lane's centre and
/// `adjacent` is empty.
struct LaneStatistics {
  std::vector<DeviationStatistics> ego;
  std::vector<DeviationStatistics> adjacent;
};

struct LaneConsistency {
  std::vector<ConsistencyStatistics> ego;
  std::vector<ConsistencyStatistics> adjacent;
};

/// What can be had without perceiving any lane, judged against the same path in the same cycles.
struct BaselineStatistics {
  std::vector<DeviationStatistics> straight;  ///< y = 0
  std::vector<DeviationStatistics> arc;       ///< the circle of the current yaw rate
  /// The same over exactly the cycles and distances in which the estimate had a deviation too: like against
  /// like.
  std::vector<DeviationStatistics> straight_where_available;
  std::vector<DeviationStatistics> arc_where_available;
};

/// The cycles in which a condition (how many vehicles, how far the next one) lay in [from, to).
struct ConditionStatistics {
  double from = 0;
  double to = 0;  ///< may be infinite
  std::uint64_t cycles = 0;
  LaneStatistics lanes;
};

/// The serial camera's own ego lane, judged by the same rules in the same cycles as the estimate.
struct SerialCameraStatistics {
  std::vector<DeviationStatistics> extrapolated;  ///< its clothoids followed as far as lanes are judged
  std::vector<DeviationStatistics> within_range;  ///< only as far as the camera itself vouches for them
};

/// All that the evaluation of one drive says.
struct EvaluationResult {
  std::string truth;      ///< "exact", "surveyed", "map" or "ego-path"
  std::string map;        ///< file name of the map that is the truth; empty: it is none
  DriveInfo drive;        ///< filled by whoever knows the drive
  std::string estimator;  ///< that the lanes are of, by the same; empty where nobody knows
  LaneStatistics lanes;
  std::uint64_t cycles = 0;
  std::uint64_t cycles_ok = 0;          ///< with status OK
  std::uint64_t cycles_with_truth = 0;  ///< in which the true ego lane, or the path, was known

  /// Everything from here on only against a road: exact, surveyed or a map.
  std::optional<SurveyedTruthConfig> surveyed;  ///< the errors that were laid on the truth
  LaneConsistency consistency;
  std::uint64_t cycles_with_ego_lane = 0;  ///< of those with truth: in which the estimate had an ego lane
  std::uint64_t cycles_in_wrong_lane =
      0;  ///< of those: a boundary of it was nearer to another true one than to its own
  std::uint64_t false_boundaries =
      0;  ///< estimated ones more than 1 m from every true one, summed over the cycles
  std::uint64_t false_lanes = 0;  ///< estimated ones that are none, summed over the cycles: see count_false()
  std::uint64_t resets = 0;       ///< how often the estimate began anew: see ResetCounter
  std::vector<ConditionStatistics> by_vehicles_ahead;  ///< number of vehicles ahead: see TrafficAhead
  std::vector<ConditionStatistics> by_gap_ahead;       ///< [m] to the next vehicle in the ego lane
  std::optional<SerialCameraStatistics> serial_camera;
  std::optional<TrackingFigures> tracking;  ///< where vehicles were tracked and the true ones are known

  /// Only against the ego path.
  std::optional<BaselineStatistics> baselines;
  std::vector<AvailabilityStatistics> availability_with_vehicle_ahead;
};

/// The rates that a reader asks for; NaN where nothing was judged.
double wrong_lane_rate(const EvaluationResult& result);
double false_boundaries_per_cycle(const EvaluationResult& result);
double false_lanes_per_cycle(const EvaluationResult& result);
/// The mean of (deviation / sigma)^2 over all distances, ego and adjacent lanes.
double mean_normalised_square(const LaneConsistency& consistency);

}  // namespace lanefuse
