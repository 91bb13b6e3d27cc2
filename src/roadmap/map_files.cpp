// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/map_files.hpp"

#include <fstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "roadmap/commonroad.hpp"
#include "roadmap/geojson.hpp"
#include "roadmap/lanelet2.hpp"
#include "roadmap/opendrive.hpp"

namespace lanefuse {
namespace {

bool is_geojson(const std::filesystem::path& path) {
  return path.extension() == ".geojson" || path.extension() == ".json";
}

std::string map_text(const RoadMap& map, const std::filesystem::path& path) {
  if (path.extension() == ".xodr") return opendrive_text(map);
  return path.extension() == ".osm" ? lanelet2_text(map) : geojson_text(map);
}

}  // namespace

RoadMap read_map(const std::filesystem::path& path) {
  if (path.extension() == ".xodr") return read_opendrive(path);
  if (path.extension() == ".osm") return read_lanelet2(path);
  if (path.extension() == ".xml") return read_commonroad(path).map;
  if (is_geojson(path)) return read_geojson(path);
  throw configuration_error(path.string(), "has an ending that is no map's",
                            "maps end with .xodr, .osm, .xml or .geojson");
}

void check_map_ending(const std::filesystem::path& path) {
  if (path.extension() == ".xodr" || path.extension() == ".osm" || is_geojson(path)) return;
  throw configuration_error(path.string(), "has an ending that no map is written with",
                            "maps are written as .xodr, .osm or .geojson");
}

void write_map(const RoadMap& map, const std::filesystem::path& path) {
  check_map_ending(path);
  const std::string text = map_text(map, path);
  const std::filesystem::path part = path.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, path, failed);
  if (out && !failed) return;
  std::filesystem::remove(part, failed);
  throw input_error(path.string(), "could not be written", "is there room on the disk?");
}

}  // namespace lanefuse
