// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roadmap/plan_view.hpp"
#include "roadmap/road_map.hpp"

namespace lanefuse {

/// Reads OpenDRIVE 1.4 to 1.7: the lanes that vehicles use, each along its driving direction, joined across
/// sections, roads and junctions. Not read: superelevation and crossfall, lane heights, objects, signals.
/// Throws an input error that names line and element.
RoadMap read_opendrive(const std::filesystem::path& path);

/// The exact reference line of a road that was generated: a clothoid after the other.
struct ExactPlan {
  struct Piece {
    double length = 0;          ///< [m]
    double curvature = 0;       ///< [1/m] at its beginning
    double curvature_rate = 0;  ///< [1/m^2]
  };
  Pose2 start;
  std::vector<Piece> pieces;
};

/// The map as OpenDRIVE 1.6 text, each group of lanes that hang together sideways or by their boundaries as
/// one road. Its reference line is `plan` where given and the map is one group, else a smooth line along its
/// longest boundary. Lanes are reproduced to 1 cm across the road. Throws an input error where lanes overlap
/// or turn back on themselves, which OpenDRIVE's one reference line cannot tell.
std::string opendrive_text(const RoadMap& map, const ExactPlan* plan = nullptr);

}  // namespace lanefuse
