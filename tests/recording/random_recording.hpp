// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rapidcheck.h>

#include "core/lane_estimate.hpp"
#include "sensors/measurement.hpp"
#include "sensors/truth.hpp"

/// Structs full of random numbers, for tests that they come back as they were. To be called inside rc::check.
namespace lanefuse::testing {

inline double number() { return *rc::gen::arbitrary<double>(); }
inline bool either() { return *rc::gen::arbitrary<bool>(); }

template <class T>
T below(T end) {
  return *rc::gen::inRange<T>(0, end);
}

template <class Enum>
Enum any_of(int count) {
  return static_cast<Enum>(below<int>(count));
}

template <class Make>
auto maybe(Make make) {
  return either() ? std::optional(make()) : std::nullopt;
}

template <class Make>
auto some(Make make) {
  std::vector<decltype(make())> items;
  for (int i = below<int>(4); i > 0; --i) items.push_back(make());
  return items;
}

template <int N>
Eigen::Matrix<double, N, N> symmetric() {
  Eigen::Matrix<double, N, N> matrix;
  for (int row = 0; row < N; ++row) {
    for (int column = row; column < N; ++column) matrix(row, column) = matrix(column, row) = number();
  }
  return matrix;
}

inline Time random_time() {
  return from_nanoseconds(*rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 62));
}
inline Stamp random_stamp() { return {random_time(), random_time(), *rc::gen::arbitrary<std::uint32_t>()}; }
inline std::uint64_t random_id() { return *rc::gen::arbitrary<std::uint64_t>(); }
inline std::int64_t random_track() {
  return *rc::gen::elementOf(std::vector<std::int64_t>{kNoTrack, -2, 0, 1, std::int64_t{1} << 40});
}
inline Clothoid random_clothoid() { return {number(), number(), number(), number()}; }
inline MarkingEvidence random_marking() { return {any_of<MarkingType>(5), any_of<MarkingColour>(3)}; }
inline Eigen::Vector2d random_point() { return {number(), number()}; }

inline Feature random_feature() {
  return {number(),       number(),          number(),        number(),        symmetric<3>(),
          random_track(), any_of<Source>(6), any_of<Side>(3), random_marking()};
}

inline ClothoidMeasurement random_clothoid_measurement() {
  return {random_clothoid(), symmetric<4>(), number(), number(), number(), any_of<Side>(3), random_marking()};
}

inline SharedError random_shared_error() { return {any_of<SharedError::Kind>(3), number()}; }

inline SerialLane random_serial_lane() {
  return {random_stamp(), maybe(random_clothoid_measurement), maybe(random_clothoid_measurement),
          maybe(number)};
}

inline MarkingFeatures random_marking_features() {
  return {random_stamp(), some(random_feature), maybe(random_shared_error)};
}

inline RadarDetection random_detection() {
  return {number(), number(), number(), maybe([] { return *rc::gen::arbitrary<std::int32_t>(); }), either()};
}

inline TrackedObject random_object() {
  TrackedObject object{*rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 62),
                       number(),
                       number(),
                       number(),
                       number(),
                       symmetric<3>()};
  object.length = number();
  object.width = number();
  object.movement = any_of<MovementState>(4);
  object.existence = number();
  object.seen_by_radar = either();
  object.seen_by_camera = either();
  return object;
}

inline TrueBoundary random_true_boundary() {
  TrueBoundary boundary{random_id(), random_marking(), number(), some(random_point)};
  boundary.points.push_back(random_point());
  return boundary;
}

inline TrueLane random_true_lane() {
  return {random_id(), random_id(), random_id(), maybe(random_id), maybe(random_id)};
}

inline BoundaryPoint random_boundary_point() { return {number(), number(), number(), number()}; }

inline LanePoint random_lane_point() {
  return {number(), number(), number(), number(), number(), number(), number()};
}

inline Lane random_lane() {
  return {random_id(), random_id(), random_id(), maybe(random_id), maybe(random_id),
          number(),    number(),    number(),    number(),         some(random_lane_point)};
}

inline Boundary random_boundary() {
  Boundary boundary{random_id(), random_clothoid(), symmetric<4>(),  number(),
                    number(),    number(),          random_marking()};
  for (auto& count : boundary.support) count = *rc::gen::arbitrary<std::uint16_t>();
  boundary.points = some(random_boundary_point);
  return boundary;
}

inline LaneEstimate random_estimate() {
  LaneEstimate estimate{random_time(), any_of<EstimateStatus>(3), any_of<StatusReason>(7), number(),
                        number()};
  estimate.boundaries = some(random_boundary);
  estimate.lanes = some(random_lane);
  for (auto& status : estimate.sources) status = any_of<SourceStatus>(3);
  estimate.inputs = {random_id(), random_id(), random_id()};
  return estimate;
}

inline DebugView random_debug_view() {
  const auto size = [] { return *rc::gen::arbitrary<std::uint32_t>(); };
  return {some([] {
            return FusedFeature{random_feature(), either(), either(), random_id()};
          }),
          some([] {
            return SwitchState{random_track(), any_of<Side>(3), random_point(), random_point(), number()};
          }),
          maybe(random_clothoid),
          {size(), size(), size()}};
}

}  // namespace lanefuse::testing
