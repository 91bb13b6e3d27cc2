// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "roadmap/boundary_offsets.hpp"
#include "roadmap/opendrive.hpp"
#include "roadmap/plan_view.hpp"
#include "roadmap/road_map.hpp"

namespace lanefuse {

/// Lanes that hang together sideways, by their boundaries or by following one another.
using LaneGroup = std::vector<const MapLane*>;
std::vector<LaneGroup> lane_groups(const RoadMap& map);

/// A group of lanes laid along one reference line: what OpenDRIVE calls a road.
class GroupLayout {
 public:
  /// A lane where it is present, by station.
  struct Span {
    const MapLane* lane = nullptr;
    double begin = 0;
    double end = 0;
  };

  /// Without `plan`, along a smooth line. Throws, naming `place`, where the lanes do not fit beside one line.
  GroupLayout(const RoadMap& map, const LaneGroup& lanes, const ExactPlan* plan, const std::string& place);

  [[nodiscard]] const PlanView& plan() const { return plan_; }
  [[nodiscard]] const BoundaryOffsets& offsets(std::uint64_t boundary) const { return offsets_.at(boundary); }
  /// The stations where lanes begin or end, and the road's own ends.
  [[nodiscard]] const std::vector<double>& section_stations() const { return stations_; }
  /// From left to right.
  [[nodiscard]] std::vector<const MapLane*> lanes_between(double from, double to) const;
  /// The boundary whose heights are the road's.
  [[nodiscard]] const BoundaryOffsets& longest() const;

 private:
  void find_spans(const LaneGroup& lanes, const std::string& place);

  PlanView plan_;
  std::map<std::uint64_t, BoundaryOffsets> offsets_;
  std::vector<Span> spans_;
  std::vector<double> stations_;
};

}  // namespace lanefuse
