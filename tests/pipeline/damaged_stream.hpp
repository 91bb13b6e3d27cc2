// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "sensors/measurement.hpp"

/// Streams as damaged drives have them, made from a sound one.
namespace lanefuse::testing {

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

struct Items {
  std::uint64_t operator()(const VehicleMotion&) const { return 1; }
  std::uint64_t operator()(const SerialLane& lane) const {
    return lane.left.has_value() + lane.right.has_value();
  }
  std::uint64_t operator()(const MarkingFeatures& markings) const { return markings.features.size(); }
  std::uint64_t operator()(const RadarScan& scan) const { return scan.detections.size(); }
  std::uint64_t operator()(const ObjectList& list) const { return list.objects.size(); }
  std::uint64_t operator()(const GnssInsFix&) const { return 0; }
  std::uint64_t operator()(const CameraImage&) const { return 1; }
  std::uint64_t operator()(const CameraBoxes& boxes) const { return boxes.boxes.size(); }
};

/// What the accounting must add up to.
inline std::uint64_t items_in(const std::vector<Measurement>& stream) {
  std::uint64_t items = 0;
  for (const Measurement& measurement : stream) items += std::visit(Items{}, measurement);
  return items;
}

/// Puts one item that is no number among the sound ones.
struct AddDamagedItem {
  void operator()(VehicleMotion&) const {}
  void operator()(SerialLane&) const {}
  void operator()(GnssInsFix&) const {}
  void operator()(CameraImage&) const {}
  void operator()(MarkingFeatures& markings) const {
    insert(markings.features, Feature{kNotANumber, 0, 0, 0.5});
  }
  void operator()(RadarScan& scan) const { insert(scan.detections, RadarDetection{kNotANumber, 0, 0}); }
  void operator()(CameraBoxes& boxes) const { insert(boxes.boxes, BoxDetection{kNotANumber, 0, 1, 1}); }
  void operator()(ObjectList& list) const { insert(list.objects, TrackedObject{77, 40, kNotANumber}); }
  static void insert(auto& list, auto damaged) {
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), damaged);
  }
};

/// Makes what a measurement says impossible, as a whole or in a part.
struct Damage {
  void operator()(VehicleMotion& motion) const { motion.yaw_rate = kNotANumber; }
  void operator()(SerialLane& lane) const {
    if (lane.left) lane.left->range_begin = -std::numeric_limits<double>::max();
  }
  void operator()(MarkingFeatures& markings) const { markings.shared_error = SharedError{{}, kNotANumber}; }
  void operator()(auto& list) const { AddDamagedItem{}(list); }
};

inline Stamp& stamp_in(Measurement& measurement) {
  return std::visit([](auto& alternative) -> Stamp& { return alternative.stamp; }, measurement);
}

/// One in ten messages is damaged, one twice there, one lost, one late by up to a second, one from the
/// future.
inline std::vector<Measurement> damaged(const std::vector<Measurement>& sound, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Measurement> stream;
  for (const Measurement& measurement : sound) {
    const auto fate = random() % 50;
    if (fate == 0) continue;
    stream.push_back(measurement);
    if (fate < 5) std::visit(AddDamagedItem{}, stream.back());
    if (fate >= 5 && fate < 8) std::visit(Damage{}, stream.back());
    if (fate >= 8 && fate < 12) stream.push_back(measurement);
    if (fate >= 12 && fate < 16)
      stamp_in(stream.back()).received_at += std::chrono::milliseconds(random() % 1000);
    if (fate == 16) stamp_in(stream.back()).measured_at += std::chrono::seconds(1);
  }
  std::ranges::stable_sort(stream, {}, [](const Measurement& m) { return stamp_of(m).received_at; });
  return stream;
}

}  // namespace lanefuse::testing
