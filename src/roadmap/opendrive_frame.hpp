// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "roadmap/road_map.hpp"
#include "roadmap/xml_element.hpp"

namespace lanefuse {

/// How an OpenDRIVE file's coordinates lie on Earth: the origin of the map, and what turns the file's points
/// into the map's frame.
struct OpenDriveFrame {
  std::optional<GeoOrigin> origin;
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> local;
};

/// From <header>'s geoReference (a PROJ text: tmerc, utm, or any with lat_0 and lon_0) and offset. The origin
/// is lat_0, lon_0, or with a plain utm the place of `first_point`. Where the text is missing or says
/// neither, the map has no origin and the file's points stay as they are.
OpenDriveFrame read_opendrive_frame(const XmlElement& root, const Eigen::Vector2d& first_point);

/// The text to write for a map's own frame.
std::string geo_reference_text(const GeoOrigin& origin);

}  // namespace lanefuse
