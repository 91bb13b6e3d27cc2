// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "roadmap/geo_frame.hpp"
#include "roadmap/geojson.hpp"
#include "roadmap/measured_line.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMiddleStep = 10;  // [m]

Json position(const GeoFrame& frame, const Eigen::Vector3d& point) {
  const GeoOrigin place = frame.place(point);
  return Json::array({place.longitude_deg, place.latitude_deg, place.height});
}

Json feature(const Json& properties, Json coordinates) {
  return {{"type", "Feature"},
          {"properties", properties},
          {"geometry", {{"type", "LineString"}, {"coordinates", std::move(coordinates)}}}};
}

Json boundary_feature(const MapBoundary& boundary, const GeoFrame& frame) {
  Json styles = Json::array();
  for (const MarkingStyle& style : boundary.styles) {
    styles.push_back({{"from", style.from},
                      {"type", to_string(style.marking.type)},
                      {"colour", to_string(style.marking.colour)},
                      {"width", style.width}});
  }
  Json coordinates = Json::array();
  for (const Eigen::Vector3d& point : boundary.points) coordinates.push_back(position(frame, point));
  return feature({{"element", "boundary"}, {"id", boundary.id}, {"styles", styles}}, std::move(coordinates));
}

Json middle_of(const RoadMap& map, const MapLane& lane, const GeoFrame& frame) {
  const MeasuredLine left(find_boundary(map, lane.left_boundary)->points);
  const MeasuredLine right(find_boundary(map, lane.right_boundary)->points);
  const double from = left.nearest(right.at(0));
  const double to = left.nearest(right.at(right.length()));
  const int steps = std::max(1, static_cast<int>((to - from) / kMiddleStep));
  Json coordinates = Json::array();
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector3d on_left = left.at(from + (to - from) * i / steps);
    coordinates.push_back(position(frame, (on_left + right.at(right.nearest(on_left))) / 2));
  }
  return coordinates;
}

Json lane_feature(const RoadMap& map, const MapLane& lane, const GeoFrame& frame) {
  Json properties = {{"element", "lane"},
                     {"id", lane.id},
                     {"kind", to_string(lane.kind)},
                     {"left_boundary", lane.left_boundary},
                     {"right_boundary", lane.right_boundary}};
  if (lane.left_lane) properties["left_lane"] = *lane.left_lane;
  if (lane.right_lane) properties["right_lane"] = *lane.right_lane;
  properties["successors"] = lane.successors;
  return feature(properties, middle_of(map, lane, frame));
}

}  // namespace

std::string geojson_text(const RoadMap& map) {
  const std::string place = map.name.empty() ? "the map" : map.name;
  check(map, place);
  if (!map.origin) {
    throw input_error(place, "does not say where on Earth it lies, as GeoJSON must",
                      "lanefuse map convert --origin LAT,LON adds it");
  }
  const GeoFrame frame(*map.origin);
  Json features = Json::array();
  for (const MapBoundary& boundary : map.boundaries) features.push_back(boundary_feature(boundary, frame));
  for (const MapLane& lane : map.lanes) features.push_back(lane_feature(map, lane, frame));
  const Json origin = {map.origin->longitude_deg, map.origin->latitude_deg, map.origin->height};
  const Json collection = {{"type", "FeatureCollection"},
                           {"name", map.name},
                           {"origin", origin},
                           {"features", std::move(features)}};
  return collection.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lanefuse
