// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/lane_estimate.hpp"
#include "core/pose2.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

struct SerialCameraBaselineConfig {
  double marking_width = 0.15;  ///< [m] of the paint, where the camera does not measure it
  Duration oldest = std::chrono::milliseconds(300);  ///< that an answer may stand on
};

/// What the serial camera alone says of the ego lane, for comparison with what the fusion makes of it
/// [IROS16, sec. III].
///
/// Its last clothoids that had been received are moved outward to the centre lines of the paint, and moved
/// from the stamp at which they were measured to the time asked for by the car's last reported speed and yaw
/// rate: the camera's latency is not held against it.
class SerialCameraBaseline {
 public:
  explicit SerialCameraBaseline(const SerialCameraBaselineConfig& config = {}) : config_(config) {}

  /// Takes serial lanes and motion, in order of receiving, and passes over everything else and what is
  /// implausible. Call it with all that was received by a time before asking for that time.
  void add(const Measurement& measurement);

  /// The ego lane as far as the camera vouches for it: boundaries 1 (left) and 2 (right) with their own
  /// ranges, and lane 1 where both are there. No boundary where the camera has been silent for too long.
  [[nodiscard]] LaneEstimate at(Time time) const;

 private:
  [[nodiscard]] Boundary boundary(const ClothoidMeasurement& measured, double outward,
                                  const Pose2& then_from_now) const;

  SerialCameraBaselineConfig config_;
  std::optional<SerialLane> lane_;
  double speed_ = 0;
  double yaw_rate_ = 0;
};

/// The same lanes with every boundary followed to `reach` [m], whatever its range.
LaneEstimate extrapolated(LaneEstimate estimate, double reach);

}  // namespace lanefuse
