// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/measurement_items.hpp"

#include <tuple>

namespace lanefuse {
namespace {

/// How many things a measurement holds: what the accounting counts.
struct ItemCount {
  std::uint64_t operator()(const VehicleMotion&) const { return 1; }
  std::uint64_t operator()(const SerialLane& lane) const {
    return (lane.left ? 1 : 0) + (lane.right ? 1 : 0);
  }
  std::uint64_t operator()(const MarkingFeatures& markings) const { return markings.features.size(); }
  std::uint64_t operator()(const RadarScan& scan) const { return scan.detections.size(); }
  std::uint64_t operator()(const ObjectList& list) const { return list.objects.size(); }
  std::uint64_t operator()(const GnssInsFix&) const { return 0; }
  std::uint64_t operator()(const CameraImage&) const { return 1; }
  std::uint64_t operator()(const CameraBoxes& boxes) const { return boxes.boxes.size(); }
};

/// Cuts a list to its bound and says how much went.
struct Bound {
  std::size_t objects;
  std::size_t features;
  std::uint64_t operator()(RadarScan& scan) const { return cut(scan.detections, objects); }
  std::uint64_t operator()(ObjectList& list) const { return cut(list.objects, objects); }
  std::uint64_t operator()(CameraBoxes& boxes) const { return cut(boxes.boxes, objects); }
  std::uint64_t operator()(MarkingFeatures& markings) const { return cut(markings.features, features); }
  std::uint64_t operator()(auto&) const { return 0; }
  static std::uint64_t cut(auto& list, std::size_t bound) {
    const std::size_t before = list.size();
    if (before > bound) list.resize(bound);
    return before - list.size();
  }
};

}  // namespace

std::uint64_t item_count(const Measurement& measurement) { return std::visit(ItemCount{}, measurement); }

std::size_t kind_of(const Measurement& measurement) {
  std::size_t kind = measurement.index() * 8;
  if (const auto* motion = std::get_if<VehicleMotion>(&measurement)) {
    kind += (motion->speed ? 1 : 0) + (motion->yaw_rate ? 2 : 0) + (motion->wheel_speeds ? 4 : 0);
  }
  return kind;
}

bool measured_before(const Measurement& a, const Measurement& b) {
  const auto key = [](const Measurement& m) {
    const Stamp& stamp = stamp_of(m);
    return std::tuple(stamp.measured_at, kind_of(m), stamp.sensor_id);
  };
  return key(a) < key(b);
}

std::uint64_t cut_to_bounds(Measurement& measurement, std::size_t objects, std::size_t features) {
  return std::visit(Bound{objects, features}, measurement);
}

}  // namespace lanefuse
