// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "core/lane_estimate.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/measurement.hpp"
#include "sensors/truth.hpp"

/// All fields of the plain structs as tuples, so that tests can compare what came back with what went in, bit
/// for bit.
namespace lanefuse {

template <int N, int M>
std::vector<double> fields(const Eigen::Matrix<double, N, M>& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}

template <class T>
auto all_fields(const std::vector<T>& items) {
  std::vector<decltype(fields(items.front()))> result;
  for (const T& item : items) result.push_back(fields(item));
  return result;
}

template <class T>
auto maybe_fields(const std::optional<T>& item) {
  return item ? std::optional(fields(*item)) : std::nullopt;
}

inline auto fields(const Clothoid& c) {
  return std::make_tuple(c.lateral_offset, c.heading, c.curvature, c.curvature_rate);
}
inline auto fields(const MarkingEvidence& m) { return std::make_tuple(m.type, m.colour); }
inline auto fields(const Stamp& s) {
  return std::make_tuple(to_nanoseconds(s.measured_at), to_nanoseconds(s.received_at), s.sensor_id);
}
inline auto fields(const Feature& f) {
  return std::make_tuple(f.x, f.y, f.heading, f.confidence, fields(f.covariance), f.track_id, f.source,
                         f.side, fields(f.marking));
}
inline auto fields(const ClothoidMeasurement& m) {
  return std::make_tuple(fields(m.clothoid), fields(m.covariance), m.range_begin, m.range_end, m.confidence,
                         m.side, fields(m.marking));
}
inline auto fields(const SharedError& e) { return std::make_tuple(e.kind, e.sigma); }
inline auto fields(const VehicleMotion& m) {
  return std::make_tuple(fields(m.stamp), m.speed, m.yaw_rate, m.wheel_speeds);
}
inline auto fields(const SerialLane& l) {
  return std::make_tuple(fields(l.stamp), maybe_fields(l.left), maybe_fields(l.right), l.marking_width);
}
inline auto fields(const MarkingFeatures& m) {
  return std::make_tuple(fields(m.stamp), all_fields(m.features), maybe_fields(m.shared_error));
}
inline auto fields(const RadarDetection& d) {
  return std::make_tuple(d.range, d.bearing, d.range_rate, d.address, d.new_track);
}
inline auto fields(const RadarScan& s) { return std::make_tuple(fields(s.stamp), all_fields(s.detections)); }
inline auto fields(const TrackedObject& o) {
  return std::make_tuple(o.id, o.x, o.y, o.heading, o.speed, fields(o.covariance), o.length, o.width,
                         o.movement, o.existence, o.seen_by_radar, o.seen_by_camera, o.last_radar,
                         o.last_camera, o.changing_lane, o.witness);
}
inline auto fields(const ObjectList& l) { return std::make_tuple(fields(l.stamp), all_fields(l.objects)); }

inline auto fields(const GnssInsFix& f) {
  return std::make_tuple(fields(f.stamp), f.latitude, f.longitude, f.height, f.heading,
                         fields(f.position_covariance), f.heading_sigma, f.kind);
}

inline auto fields(const BoxDetection& b) {
  return std::make_tuple(b.left, b.top, b.right, b.bottom, b.confidence);
}
inline auto fields(const CameraBoxes& b) { return std::make_tuple(fields(b.stamp), all_fields(b.boxes)); }

inline auto fields(const CameraImage& i) { return std::make_tuple(fields(i.stamp), i.format, i.bytes); }

inline auto fields(const Mounting& m) { return std::make_tuple(m.x, m.y, m.z, m.roll, m.pitch, m.yaw); }
inline auto fields(const CameraPose& p) {
  return std::make_tuple(fields(p.mounting), p.vertical_curvature, fields(p.covariance),
                         p.vertical_curvature_sigma);
}
inline auto fields(const VehicleBox& b) {
  return std::make_tuple(b.left, b.top, b.right, b.bottom, b.distance, b.lateral, b.width, b.confidence);
}
inline auto fields(const SearchWindow& w) {
  return std::make_tuple(w.row, w.left, w.right, w.side, w.found, w.column);
}
inline auto fields(const ImageBar& b) { return std::make_tuple(b.row, b.left, b.right, b.believed); }
inline auto fields(const CameraView& v) {
  return std::make_tuple(v.sensor_id, v.measured_at, v.fault, v.calibration, fields(v.pose),
                         all_fields(v.vehicles), all_fields(v.windows), all_fields(v.bars));
}

inline auto fields(const TrueBoundary& b) {
  return std::make_tuple(b.id, fields(b.marking), b.marking_width, all_fields(b.points));
}
inline auto fields(const TrueLane& l) {
  return std::make_tuple(l.id, l.left_boundary, l.right_boundary, l.left_lane, l.right_lane);
}
inline auto fields(const TrueRoad& r) {
  return std::make_tuple(all_fields(r.boundaries), all_fields(r.lanes));
}

inline auto fields(const BoundaryPoint& p) { return std::make_tuple(p.x, p.y, p.sigma, p.protection); }
inline auto fields(const Boundary& b) {
  return std::make_tuple(b.id, fields(b.clothoid), fields(b.covariance), b.range_begin, b.range_end,
                         b.confidence, fields(b.marking), b.support, all_fields(b.points));
}
inline auto fields(const LanePoint& p) {
  return std::make_tuple(p.x, p.y, p.heading, p.curvature, p.width, p.sigma, p.width_sigma);
}
inline auto fields(const Lane& l) {
  return std::make_tuple(l.id, l.left_boundary, l.right_boundary, l.left_lane, l.right_lane, l.range_begin,
                         l.range_end, l.confidence, l.availability, all_fields(l.centre));
}
inline auto fields(const LaneEstimate& e) {
  return std::make_tuple(to_nanoseconds(e.time), e.status, e.reason, e.speed, e.yaw_rate,
                         all_fields(e.boundaries), all_fields(e.lanes), e.sources,
                         std::make_tuple(e.inputs.used, e.inputs.rejected, e.inputs.dropped));
}
inline auto fields(const FusedFeature& f) {
  return std::make_tuple(fields(f.feature), f.in_base_fit, f.outlier, f.boundary);
}
inline auto fields(const SwitchState& s) {
  return std::make_tuple(s.track_id, s.side, fields(s.from), fields(s.to), s.value);
}
inline auto fields(const DebugView& v) {
  return std::make_tuple(all_fields(v.features), all_fields(v.switches), maybe_fields(v.base_clothoid),
                         v.graph.poses, v.graph.features, v.graph.edges);
}

}  // namespace lanefuse
