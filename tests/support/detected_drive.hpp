// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "support/detected_traffic.hpp"
#include "support/simulated_run.hpp"

/// From a simulated drive with detections to lanes and tracks.
namespace lanefuse::testing {

inline constexpr Duration kDetectionLatency = std::chrono::milliseconds(40);

inline double seconds_of(Time time) { return to_seconds(time - kSimulationStart); }

/// A simulated drive whose object list has given way to detections.
inline SimulatedDrive detected_drive(std::uint64_t seed = 1, double km = 0.4) {
  SimulatedDrive drive = simulate({seed, km});
  std::erase_if(drive.measurements,
                [](const Measurement& m) { return std::holds_alternative<ObjectList>(m); });
  for (const SensorDescription& sensor : object_sensors()) drive.rig.sensors.push_back(sensor);
  DetectedTraffic detected(1, true, static_cast<unsigned>(seed));
  for (const TrueFrame& frame : drive.truth) {
    for (Measurement& look : detected.looks(frame)) {
      std::visit([](auto& message) { message.stamp.received_at += kDetectionLatency; }, look);
      drive.measurements.push_back(std::move(look));
    }
  }
  std::ranges::stable_sort(drive.measurements, {},
                           [](const Measurement& m) { return stamp_of(m).received_at; });
  return drive;
}

struct CycleResult {
  LaneEstimate lanes;
  std::vector<TrackedObject> objects;
  std::vector<std::uint32_t> distrusted;
};

inline std::vector<CycleResult> run(const Rig& rig, const std::vector<Measurement>& stream) {
  MultiLanePerception perception({}, rig);
  std::vector<CycleResult> cycles;
  for (const Measurement& measurement : stream) {
    while (const LaneEstimate* lanes = perception.advance(stamp_of(measurement).received_at)) {
      const auto objects = perception.objects();
      const auto distrusted = perception.distrusted_sensors();
      cycles.push_back({*lanes, {objects.begin(), objects.end()}, {distrusted.begin(), distrusted.end()}});
    }
    perception.add(measurement);
  }
  return cycles;
}

}  // namespace lanefuse::testing
