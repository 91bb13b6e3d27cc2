// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "evaluation/exact_truth.hpp"
#include "evaluation/true_frames.hpp"
#include "pipeline/perception.hpp"
#include "simulation/drive_simulation.hpp"

/// From a simulated drive to judged lanes, as the command line does it with files in between.
namespace lanefuse::testing {

struct SimulatedDrive {
  Rig rig;
  TrueRoad road;
  std::vector<Measurement> measurements;  ///< in the order of receiving
  std::vector<TrueFrame> truth;
};

inline SimulatedDrive simulate(const SimulationConfig& config) {
  DriveSimulation simulation(config, nominal_preset());
  SimulatedDrive drive{simulation.rig(), simulation.road(), {}, {}};
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  for (bool more = true; more;) {
    more = simulation.step(measurements, truth);
    std::move(measurements.begin(), measurements.end(), std::back_inserter(drive.measurements));
    std::move(truth.begin(), truth.end(), std::back_inserter(drive.truth));
  }
  return drive;
}

/// Ten seconds on which much happens: what tests of behaviour take apart.
inline SimulatedDrive short_drive(std::uint64_t seed = 1) { return simulate({seed, 0.3}); }

/// Every cycle that the measurements make due, and one more for what came after the last of them.
inline std::vector<LaneEstimate> perceive(MultiLanePerception& perception,
                                          std::span<const Measurement> measurements) {
  std::vector<LaneEstimate> estimates;
  Time last{};
  for (const Measurement& measurement : measurements) {
    last = stamp_of(measurement).received_at;
    while (const LaneEstimate* lanes = perception.advance(last)) estimates.push_back(*lanes);
    perception.add(measurement);
  }
  const std::size_t due = estimates.size() + 1;
  while (estimates.size() < due) {
    const LaneEstimate* lanes = perception.advance(last += std::chrono::milliseconds(10));
    if (lanes) estimates.push_back(*lanes);
    if (measurements.empty()) break;
  }
  return estimates;
}

inline std::vector<LaneEstimate> perceive(const SimulatedDrive& drive, const PerceptionConfig& config = {}) {
  MultiLanePerception perception(config, drive.rig);
  return perceive(perception, drive.measurements);
}

inline EvaluationResult judge(const SimulatedDrive& drive, std::span<const LaneEstimate> estimates) {
  ExactTruthEvaluation evaluation(drive.road);
  for (const LaneEstimate& estimate : estimates) {
    const auto frame = frame_at(drive.truth, estimate.time);
    frame ? evaluation.add(estimate, *frame) : evaluation.add_without_truth(estimate);
  }
  return evaluation.result();
}

/// Bit by bit the same boundary.
inline bool same_boundary(const Boundary& a, const Boundary& b) {
  const auto same_point = [](const BoundaryPoint& p, const BoundaryPoint& q) {
    return p.x == q.x && p.y == q.y && p.sigma == q.sigma && p.protection == q.protection;
  };
  return a.id == b.id && a.clothoid == b.clothoid && a.covariance == b.covariance &&
         a.range_begin == b.range_begin && a.range_end == b.range_end && a.confidence == b.confidence &&
         a.marking == b.marking && a.support == b.support &&
         std::ranges::equal(a.points, b.points, same_point);
}

inline bool same_lane(const Lane& a, const Lane& b) {
  const auto same_point = [](const LanePoint& p, const LanePoint& q) {
    return p.x == q.x && p.y == q.y && p.heading == q.heading && p.curvature == q.curvature &&
           p.width == q.width && p.sigma == q.sigma && p.width_sigma == q.width_sigma;
  };
  return a.id == b.id && a.left_boundary == b.left_boundary && a.right_boundary == b.right_boundary &&
         a.left_lane == b.left_lane && a.right_lane == b.right_lane && a.range_begin == b.range_begin &&
         a.range_end == b.range_end && a.confidence == b.confidence && a.availability == b.availability &&
         std::ranges::equal(a.centre, b.centre, same_point);
}

/// Bit by bit the same road; what became of the inputs may differ.
inline bool same_road(const LaneEstimate& a, const LaneEstimate& b) {
  return a.time == b.time && a.status == b.status && a.reason == b.reason && a.speed == b.speed &&
         a.yaw_rate == b.yaw_rate && a.sources == b.sources && a.witnesses == b.witnesses &&
         std::ranges::equal(a.boundaries, b.boundaries, same_boundary) &&
         std::ranges::equal(a.lanes, b.lanes, same_lane);
}

/// The first cycle at which two runs differ, or their length.
inline std::size_t first_difference(std::span<const LaneEstimate> a, std::span<const LaneEstimate> b) {
  const auto [in_a, in_b] = std::ranges::mismatch(a, b, same_road);
  return static_cast<std::size_t>(in_a - a.begin());
}

}  // namespace lanefuse::testing
