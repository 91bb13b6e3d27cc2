// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// Reads a Lanelet2 map (OpenStreetMap XML): lanelets whose bounds are the same way are neighbours, those
/// that meet in the same two nodes follow one another. Places come from lat and lon, with the first node (or
/// the node tagged local_origin=yes) as origin; where these are all 0, from the tags local_x and local_y.
/// Throws an input error that names line and element.
RoadMap read_lanelet2(const std::filesystem::path& path);

/// The map as Lanelet2. Boundaries are cut where their paint changes and where lanes begin or end, so a lane
/// may become several lanelets; the first has the lane's id. Without an origin lat and lon are 0.
std::string lanelet2_text(const RoadMap& map);

}  // namespace lanefuse
