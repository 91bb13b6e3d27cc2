// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "roadmap/plan_view.hpp"
#include "roadmap/road_map.hpp"
#include "roadmap/xml_element.hpp"

namespace lanefuse {

/// A quantity along the road, cubic piece by piece. Before the first piece it is 0.
struct CubicTable {
  struct Piece {
    double from = 0;  ///< [m]
    Cubic cubic;      ///< of the distance from there
  };
  std::vector<Piece> pieces;  ///< in order

  [[nodiscard]] double at(double station) const;
};

/// One lane of one section, as the file has it.
struct OpenDriveLane {
  XmlElement element;
  std::int64_t id = 0;           ///< > 0 left of the centre, < 0 right of it
  std::optional<LaneKind> kind;  ///< nothing for what is no lane (border, none, median, kerb)
  CubicTable extent;  ///< width, or signed offset of the outer border [m], from the section's begin
  bool extent_is_border = false;
  std::vector<MarkingStyle> marks;  ///< of the outer edge; `from` counts from the section's begin
};

struct OpenDriveSection {
  XmlElement element;
  double from = 0;  ///< [m] along the road
  double to = 0;
  std::vector<OpenDriveLane> lanes;  ///< by falling id, so from left to right; the centre is among them
};

struct OpenDriveRoad {
  XmlElement element;
  std::string id;
  double length = 0;
  bool left_hand_traffic = false;
  PlanView plan;
  CubicTable elevation;
  CubicTable lane_offset;
  std::vector<OpenDriveSection> sections;

  /// Whether lanes of that id are driven along the road's stations.
  [[nodiscard]] bool is_forward(std::int64_t lane) const { return (lane < 0) != left_hand_traffic; }
};

OpenDriveRoad read_opendrive_road(const XmlElement& road);

/// A road's <planView>, whose elements must reach to `length` [m].
PlanView read_plan_view(const XmlElement& element, double length);

/// The pieces of the children of that name, by their attribute `offset` ("s" or "sOffset").
CubicTable read_cubics(const XmlElement& parent, const char* name, const char* offset);

}  // namespace lanefuse
