// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/feature.hpp"
#include "core/pose2.hpp"
#include "core/time.hpp"

namespace lanefuse {

/// What is really there. Written by simulators and importers, read by the evaluation; never by anything that
/// estimates.

/// The centre line of a marking in the world frame, along the driving direction.
struct TrueBoundary {
  std::uint64_t id = 0;
  MarkingEvidence marking;
  double marking_width = 0.15;  ///< [m] of the paint
  std::vector<Eigen::Vector2d> points;
};

struct TrueLane {
  std::uint64_t id = 0;
  std::uint64_t left_boundary = 0;
  std::uint64_t right_boundary = 0;
  std::optional<std::uint64_t> left_lane;
  std::optional<std::uint64_t> right_lane;
};

struct TrueRoad {
  std::vector<TrueBoundary> boundaries;  ///< from left to right
  std::vector<TrueLane> lanes;           ///< from left to right; the emergency lane is none
};

struct TrueObject {
  std::int64_t id = 0;
  Pose2 world_from_object;  ///< middle of its rear
  double speed = 0;         ///< [m/s]
  double length = 4.5;      ///< [m]
  double width = 1.8;       ///< [m]
};

/// Where everything was at one moment.
struct TrueFrame {
  Time time{};
  Pose2 world_from_vehicle;
  double speed = 0;     ///< [m/s]
  double yaw_rate = 0;  ///< [rad/s]
  std::vector<TrueObject> objects;
};

}  // namespace lanefuse
