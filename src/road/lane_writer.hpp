// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/lane_estimate.hpp"
#include "road/road_state.hpp"

namespace lanefuse {

/// Says what the state knows, as boundaries and lanes in the vehicle frame: points along each line with their
/// lateral sigma and protection level, and the clothoid that fits them best [IROS16, eq. 11].
class LaneWriter {
 public:
  explicit LaneWriter(const RoadConfig& config) : config_(config) {}

  /// Writes boundaries and lanes; the axis must be up to date.
  void write(const RoadState& state, LaneEstimate& estimate);
  void clear();

 private:
  struct KnownLane {
    std::uint64_t left = 0;
    std::uint64_t right = 0;
    std::uint64_t id = 0;
  };

  void write_boundary(const RoadState& state, const KnownLine& line, Boundary& boundary);
  [[nodiscard]] double sigma_of(const RoadState& state, const KnownLine& line, double station) const;
  void write_points(const RoadState& state, const KnownLine& line, Boundary& boundary);
  void fit_clothoid(const RoadState& state, const KnownLine& line, Boundary& boundary) const;
  struct Stretch {
    double begin = 0;
    double end = -1;
  };
  static Stretch lane_stretch(const Boundary& left, const Boundary& right);
  [[nodiscard]] bool is_shoulder(const RoadState& state, std::size_t left, double usual_width) const;
  [[nodiscard]] double usual_width(const RoadState& state) const;
  void write_lanes(const RoadState& state, LaneEstimate& estimate);
  void keep_what_bounds(LaneEstimate& estimate);
  std::uint64_t lane_id(std::uint64_t left, std::uint64_t right);

  RoadConfig config_;
  std::vector<const KnownLine*> from_left_;
  std::vector<std::vector<BoundaryPoint>> spare_points_;
  std::vector<KnownLane> known_lanes_;
  std::uint64_t next_lane_ = 1;
};

}  // namespace lanefuse
