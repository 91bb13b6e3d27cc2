// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/map_command.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "roadmap/map_files.hpp"
#include "roadmap/measured_line.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

constexpr std::size_t kWidths = 1000;  // measured along a lane at most

/// The distance between a lane's boundaries, at points of the left one that lie beside the right one.
Range width_of(const RoadMap& map, const MapLane& lane) {
  const MapBoundary& left = *find_boundary(map, lane.left_boundary);
  const MeasuredLine right(find_boundary(map, lane.right_boundary)->points);
  Range width;
  const std::size_t stride = 1 + left.points.size() / kWidths;
  for (std::size_t i = 0; i < left.points.size(); i += stride) {
    const Eigen::Vector3d& point = left.points[i];
    const double arc = right.nearest(point);
    if (arc > 0 && arc < right.length()) width.add((point - right.at(arc)).head<2>().norm());
  }
  return width;
}

/// As long as the shorter of its boundaries.
double length_of(const RoadMap& map, const MapLane& lane) {
  return std::min(MeasuredLine(find_boundary(map, lane.left_boundary)->points).length(),
                  MeasuredLine(find_boundary(map, lane.right_boundary)->points).length());
}

Json lane_json(const RoadMap& map, const MapLane& lane) {
  const Range width = width_of(map, lane);
  const auto id = [](const std::optional<std::uint64_t>& other) {
    return other ? Json(*other) : Json(nullptr);
  };
  const bool has_width = width.least <= width.most;
  return {{"id", lane.id},
          {"kind", to_string(lane.kind)},
          {"length", length_of(map, lane)},
          {"width_min", has_width ? Json(width.least) : Json(nullptr)},
          {"width_max", has_width ? Json(width.most) : Json(nullptr)},
          {"left_boundary", lane.left_boundary},
          {"right_boundary", lane.right_boundary},
          {"left_lane", id(lane.left_lane)},
          {"right_lane", id(lane.right_lane)},
          {"successors", lane.successors}};
}

Json boundary_json(const MapBoundary& boundary) {
  Json styles = Json::array();
  for (const MarkingStyle& style : boundary.styles) {
    styles.push_back(Json{{"from", style.from},
                          {"type", to_string(style.marking.type)},
                          {"colour", to_string(style.marking.colour)},
                          {"width", style.width}});
  }
  return {{"id", boundary.id},
          {"length", MeasuredLine(boundary.points).length()},
          {"points", boundary.points.size()},
          {"styles", styles}};
}

Json map_json(const RoadMap& map) {
  Json json = {{"name", map.name}, {"origin", nullptr}};
  if (map.origin) {
    json["origin"] = Json{{"latitude_deg", map.origin->latitude_deg},
                          {"longitude_deg", map.origin->longitude_deg},
                          {"height", map.origin->height}};
  }
  json["lanes"] = Json::array();
  for (const MapLane& lane : map.lanes) json["lanes"].push_back(lane_json(map, lane));
  json["boundaries"] = Json::array();
  for (const MapBoundary& boundary : map.boundaries) json["boundaries"].push_back(boundary_json(boundary));
  return json;
}

/// How a boundary is painted half-way along the other one of its lane.
const char* paint(const RoadMap& map, std::uint64_t boundary_id, std::uint64_t beside) {
  const MapBoundary& boundary = *find_boundary(map, boundary_id);
  const MeasuredLine other(find_boundary(map, beside)->points);
  const double arc = MeasuredLine(boundary.points).nearest(other.at(other.length() / 2));
  return to_string(style_at(boundary, arc).marking.type);
}

std::string lane_line(const RoadMap& map, const MapLane& lane) {
  const Range width = width_of(map, lane);
  const std::string range =
      width.least <= width.most ? fmt::format("{:.2f}-{:.2f} m", width.least, width.most) : "unknown";
  return fmt::format("  {:>8}  {:<9}  {:8.1f} m  {:>12} wide  {} | {}\n", lane.id, to_string(lane.kind),
                     length_of(map, lane), range, paint(map, lane.left_boundary, lane.right_boundary),
                     paint(map, lane.right_boundary, lane.left_boundary));
}

void print_map(const RoadMap& map) {
  fmt::print("{}: {} lanes, {} boundaries\n", map.name.empty() ? "unnamed" : map.name, map.lanes.size(),
             map.boundaries.size());
  if (map.origin) {
    fmt::print("origin {:.7f} deg, {:.7f} deg, height {:.1f} m\n", map.origin->latitude_deg,
               map.origin->longitude_deg, map.origin->height);
  } else {
    fmt::print("origin unknown\n");
  }
  if (!map.lanes.empty()) {
    fmt::print("  {:>8}  {:<9}  {:>10}  {:>17}  {}\n", "lane", "kind", "length", "width",
               "paint left | right, half-way");
  }
  for (const MapLane& lane : map.lanes) fmt::print("{}", lane_line(map, lane));
}

GeoOrigin parse_origin(const std::string& text) {
  std::istringstream in(text);
  GeoOrigin origin;
  char comma = 0;
  const bool read = static_cast<bool>(in >> origin.latitude_deg >> comma >> origin.longitude_deg);
  const bool sound = read && comma == ',' && in.peek() == std::istringstream::traits_type::eof() &&
                     std::abs(origin.latitude_deg) <= 90 && std::abs(origin.longitude_deg) <= 180;
  if (!sound) {
    throw configuration_error("--origin", fmt::format("'{}' is no place", text),
                              "write it as 48.2,11.6 [deg]");
  }
  return origin;
}

}  // namespace

int map_info(const MapInfoOptions& options) {
  const RoadMap map = read_map(options.map);
  if (options.json) {
    fmt::print("{}\n", map_json(map).dump(-1, ' ', false, Json::error_handler_t::replace));
  } else {
    print_map(map);
  }
  return 0;
}

int map_convert(const MapConvertOptions& options) {
  check_map_ending(options.output);
  check_output(options.output, options.force, options.map);
  const auto origin = options.origin.empty() ? std::nullopt : std::optional(parse_origin(options.origin));
  RoadMap map = read_map(options.map);
  if (map.name.empty()) map.name = options.map.stem().string();
  if (origin) map.origin = origin;
  write_map(map, options.output);
  if (options.json) {
    fmt::print("{}\n", Json{{"output", options.output.string()},
                            {"lanes", map.lanes.size()},
                            {"boundaries", map.boundaries.size()}}
                           .dump());
  } else {
    fmt::print("{} lanes, {} boundaries -> {}\n", map.lanes.size(), map.boundaries.size(),
               options.output.string());
  }
  return 0;
}

}  // namespace lanefuse
