// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/motion.hpp"
#include "objects/radar_tracker.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "sources/witness.hpp"

namespace lanefuse {

/// What a tracker must beat: all radars' scans through the plain nearest-neighbour tracker, no camera,
/// nothing verified. Any track that drives counts, and bears witness by the rule `radar_only`.
class NearestNeighbour {
 public:
  explicit NearestNeighbour(const Rig& rig) : rig_(rig) { witness_.rule = WitnessRule::radar_only; }

  /// Scans in order of measuring; other measurements are not for it. `motion` reaches to about now.
  void add(const Measurement& measurement, std::span<const MotionSample> motion);

  /// The tracks that drive, moved to `now`, in the vehicle frame.
  [[nodiscard]] std::vector<TrackedObject> objects(Time now, std::span<const MotionSample> motion) const;

 private:
  const Rig& rig_;
  WitnessConfig witness_;
  RadarTracker tracker_{RadarTrackerConfig{}};
  std::optional<Time> last_scan_;
};

}  // namespace lanefuse
