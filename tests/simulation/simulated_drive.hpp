// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/drive_simulation.hpp"

namespace lanefuse::testing {

struct Drive {
  Rig rig;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
};

inline Drive drive(const SimulationConfig& config) {
  DriveSimulation simulation(config, nominal_preset());
  Drive drive{simulation.rig(), {}, {}};
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  while (simulation.step(measurements, truth)) {
    drive.measurements.insert(drive.measurements.end(), measurements.begin(), measurements.end());
    drive.truth.insert(drive.truth.end(), truth.begin(), truth.end());
  }
  return drive;
}

inline SimulationConfig short_drive(std::uint64_t seed) {
  SimulationConfig config;
  config.seed = seed;
  config.km = 0.6;
  return config;
}

/// Every bit of some numbers that a message carries.
class Digest {
 public:
  void operator()(const VehicleMotion& m) { add({*m.speed, *m.yaw_rate}); }
  void operator()(const SerialLane& m) {
    for (const auto* side : {&m.left, &m.right}) {
      if (*side) add({(*side)->clothoid.y(50), (*side)->covariance.sum(), (*side)->range_end});
    }
  }
  void operator()(const MarkingFeatures& m) {
    for (const Feature& f : m.features) add({f.x, f.y, f.heading, f.covariance.sum()});
  }
  void operator()(const ObjectList& m) {
    for (const TrackedObject& o : m.objects) add({o.x, o.y, o.heading, o.speed, double(o.seen_by_camera)});
  }
  void operator()(const RadarScan& m) {
    for (const RadarDetection& d : m.detections) add({d.range, d.bearing, d.range_rate});
  }
  void operator()(const CameraBoxes& m) {
    for (const BoxDetection& b : m.boxes) add({b.left, b.top, b.right, b.bottom, b.confidence});
  }
  void operator()(const CameraImage& m) {
    text_.append(reinterpret_cast<const char*>(m.bytes.data()), m.bytes.size());
  }
  void operator()(const GnssInsFix& m) { add({m.latitude, m.longitude, m.height, m.heading}); }
  void add(std::initializer_list<double> numbers) {
    for (const double number : numbers) text_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  [[nodiscard]] std::size_t value() const { return std::hash<std::string>{}(text_); }

 private:
  std::string text_;
};

inline std::size_t digest(const Drive& drive, std::optional<std::uint32_t> sensor = {}) {
  Digest digest;
  for (const Measurement& measurement : drive.measurements) {
    if (!sensor || stamp_of(measurement).sensor_id == *sensor) std::visit(digest, measurement);
  }
  return digest.value();
}

inline std::size_t digest_truth(const Drive& drive) {
  Digest digest;
  for (const TrueFrame& frame : drive.truth) {
    digest.add({frame.world_from_vehicle.x, frame.world_from_vehicle.y, frame.speed, frame.yaw_rate});
    for (const TrueObject& object : frame.objects) digest.add({object.world_from_object.x, object.speed});
  }
  return digest.value();
}

}  // namespace lanefuse::testing
