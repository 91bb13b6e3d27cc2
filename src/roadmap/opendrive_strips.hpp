// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "roadmap/lane_strips.hpp"
#include "roadmap/opendrive_road.hpp"

namespace lanefuse {

/// A point of the file's frame in the map's.
using PointConversion = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// A strip together with the lane of the file that it was made of.
struct OpenDriveStrip {
  LaneStrip strip;  ///< without id and successors; neighbours count within its section
  std::size_t section = 0;
  std::int64_t lane = 0;
};

/// The strips of one section's lanes, from left to right: sampled so that chords are within 5 mm of the curve
/// and points at most 2 m apart. Lanes that have no width anywhere, and what is no lane, are left out. Takes
/// the points it makes from `points_left`, and throws where they do not suffice.
std::vector<OpenDriveStrip> sample_section(const OpenDriveRoad& road, std::size_t index,
                                           const PointConversion& convert, std::size_t& points_left);

}  // namespace lanefuse
