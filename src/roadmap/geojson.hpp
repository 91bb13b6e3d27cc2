// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "roadmap/road_map.hpp"

namespace lanefuse {

/// The map as GeoJSON (RFC 7946: WGS 84, longitude first), to be laid over an aerial picture: a LineString a
/// boundary and one along the middle of each lane, with what is known of them as properties. Throws an input
/// error where the map's origin is not known.
std::string geojson_text(const RoadMap& map);

/// Reads what geojson_text() writes; lanes' lines are only for looking. Throws an input error that names the
/// feature and its member.
RoadMap read_geojson(const std::filesystem::path& path);

}  // namespace lanefuse
