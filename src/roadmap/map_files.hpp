// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// Reads a map by the ending of its name: .xodr (OpenDRIVE), .osm (Lanelet2), .xml (CommonRoad), .geojson or
/// .json (GeoJSON). Throws a configuration error for any other ending, an input error for what is in the
/// file.
RoadMap read_map(const std::filesystem::path& path);

/// Writes a map, whole or not at all, by the ending of the name: .xodr, .osm, .geojson or .json.
void write_map(const RoadMap& map, const std::filesystem::path& path);

/// Throws what write_map() would for the ending alone, before any work is done.
void check_map_ending(const std::filesystem::path& path);

}  // namespace lanefuse
