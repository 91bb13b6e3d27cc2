// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sources/feature_source.hpp"

namespace lanefuse::testing {

inline constexpr Time kNow{std::chrono::seconds(1000)};
inline constexpr Stamp kStamp{kNow, kNow, 3};

/// A rig with the sensor that kStamp names, at the origin.
inline const Rig kRig{{{3, SensorKind::long_range_radar, "front", {}}}};

/// A source and what it may look at: no motion and no lane width, unless a test gives them.
struct SourceUnderTest {
  FeatureSource& source;
  std::vector<MotionSample> motion;
  std::optional<LaneWidth> lane_width;

  InputAccounting add(const Measurement& measurement) {
    return source.add(measurement, {kRig, motion, lane_width});
  }
  std::vector<FeatureSet> collect() {
    std::vector<FeatureSet> sets;
    source.collect(kNow, {kRig, motion, lane_width}, sets);
    return sets;
  }
};

inline std::vector<Measurement> one_of_each() {
  ClothoidMeasurement clothoid;
  clothoid.range_end = 40;
  return {VehicleMotion{kStamp, 30.0, 0.0}, SerialLane{kStamp, clothoid, clothoid},
          MarkingFeatures{kStamp, {Feature{40, 2, 0, 0.5}}}, RadarScan{kStamp, {RadarDetection{40, 0, 0}}},
          ObjectList{kStamp, {TrackedObject{1, 40, 0, 0, 30}}}};
}

/// The indices, among one_of_each(), of what a source counted as its own.
inline std::vector<std::size_t> taken_by(FeatureSource& source) {
  SourceUnderTest test{source};
  std::vector<std::size_t> taken;
  const std::vector<Measurement> measurements = one_of_each();
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (test.add(measurements[i]) != InputAccounting{}) taken.push_back(i);
  }
  return taken;
}

}  // namespace lanefuse::testing
