// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/feature.hpp"
#include "core/lane_estimate.hpp"
#include "core/motion.hpp"
#include "core/time.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// What a source may look at beside its own measurements.
struct SourceContext {
  const Rig& rig;
  std::span<const MotionSample> motion;  ///< dead reckoning, in order of time; may be empty
  std::optional<LaneWidth> lane_width;   ///< as the serial camera sees the ego lane, where it does
};

/// One of S_1..S_N of the paper's Fig. 1: turns a sensor's measurements into generic lane features.
///
/// A new sensor is one file here: implement the two functions, and add it to the list in the pipeline.
class FeatureSource {
 public:
  virtual ~FeatureSource() = default;

  /// Takes a measurement, if it is this source's to take. The result counts its items (features, objects,
  /// detections, clothoids): all zero for a measurement that is another source's. Bad items are rejected,
  /// never thrown for.
  virtual InputAccounting add(const Measurement& measurement, const SourceContext& context) = 0;

  /// Appends what has come together since the last call.
  virtual void collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) = 0;

  virtual void reset() = 0;
};

}  // namespace lanefuse
