// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "roadmap/geo_frame.hpp"
#include "roadmap/geojson.hpp"
#include "roadmap/map_text.hpp"

namespace lanefuse {
namespace {

using Json = nlohmann::json;

constexpr int kMostDepth = 64;
constexpr std::int64_t kMostValues = 4'000'000;

/// A value in the file, and where it stands there.
class JsonPlace {
 public:
  JsonPlace(const Json& value, std::string path) : value_(&value), path_(std::move(path)) {}

  [[nodiscard]] Error error(const std::string& problem) const { return input_error(path_, problem); }
  [[nodiscard]] const Json& json() const { return *value_; }

  [[nodiscard]] std::optional<JsonPlace> find(const char* key) const {
    if (!value_->is_object()) throw error("is no object");
    const auto found = value_->find(key);
    if (found == value_->end() || found->is_null()) return std::nullopt;
    return JsonPlace(*found, fmt::format("{}.{}", path_, key));
  }
  [[nodiscard]] JsonPlace at(const char* key) const {
    const std::optional<JsonPlace> found = find(key);
    if (!found) throw error(fmt::format("has no '{}'", key));
    return *found;
  }
  [[nodiscard]] std::vector<JsonPlace> items() const {
    if (!value_->is_array()) throw error("is no list");
    std::vector<JsonPlace> items;
    for (std::size_t i = 0; i < value_->size(); ++i)
      items.emplace_back((*value_)[i], fmt::format("{}[{}]", path_, i));
    return items;
  }
  [[nodiscard]] double number(double from, double to) const {
    const double value = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(value >= from && value <= to)) throw error(fmt::format("is no number from {} to {}", from, to));
    return value;
  }
  [[nodiscard]] std::uint64_t id() const {
    if (!value_->is_number_unsigned() || *value_ == 0) throw error("is no id");
    return value_->get<std::uint64_t>();
  }
  [[nodiscard]] std::string text() const {
    if (!value_->is_string()) throw error("is no text");
    return value_->get<std::string>();
  }
  /// The enumerator of that name, of `count`.
  template <typename Enum>
  [[nodiscard]] Enum name_of(int count) const {
    for (int i = 0; i < count; ++i) {
      if (text() == to_string(static_cast<Enum>(i))) return static_cast<Enum>(i);
    }
    throw error(fmt::format("is '{}', which is none of the known names", text().substr(0, 40)));
  }

 private:
  const Json* value_;
  std::string path_;
};

Json parse(const std::filesystem::path& path) {
  const std::string text = read_map_text(path);
  std::int64_t values = 0;
  for (const char c : text) values += c == ',' || c == '[' || c == '{' ? 1 : 0;
  if (values > kMostValues) {
    throw input_error(path.string(), fmt::format("has more than {} values", kMostValues),
                      "cut the map into smaller ones");
  }
  const auto check_depth = [&path](int depth, Json::parse_event_t, Json&) {
    if (depth > kMostDepth) {
      throw input_error(path.string(), fmt::format("is nested deeper than {} levels", kMostDepth));
    }
    return true;
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const Json::parse_error& error) {
    throw input_error(fmt::format("{}, byte {}", path.string(), error.byte), "is no sound JSON");
  } catch (const Json::exception&) {
    throw input_error(path.string(), "is no sound JSON");
  }
}

/// A position on Earth, as GeoJSON has it: longitude first.
GeoOrigin read_place(const JsonPlace& position) {
  const std::vector<JsonPlace> numbers = position.items();
  if (numbers.size() < 2 || numbers.size() > 3) throw position.error("has not two or three numbers");
  return {numbers[1].number(-90, 90), numbers[0].number(-180, 180),
          numbers.size() == 3 ? numbers[2].number(-1e6, 1e6) : 0};
}

MarkingStyle read_style(const JsonPlace& style) {
  return {style.at("from").number(0, 1e9),
          {style.at("type").name_of<MarkingType>(5), style.at("colour").name_of<MarkingColour>(3)},
          style.at("width").number(0, 2)};
}

MapBoundary read_boundary(const JsonPlace& properties, const JsonPlace& feature, const GeoFrame& frame) {
  MapBoundary boundary{properties.at("id").id(), {}, {}};
  for (const JsonPlace& style : properties.at("styles").items()) boundary.styles.push_back(read_style(style));
  const JsonPlace geometry = feature.at("geometry");
  if (geometry.at("type").text() != "LineString") throw geometry.error("is no LineString");
  for (const JsonPlace& position : geometry.at("coordinates").items()) {
    boundary.points.push_back(frame.local(read_place(position)));
  }
  return boundary;
}

MapLane read_lane(const JsonPlace& properties) {
  MapLane lane;
  lane.id = properties.at("id").id();
  lane.kind = properties.at("kind").name_of<LaneKind>(5);
  lane.left_boundary = properties.at("left_boundary").id();
  lane.right_boundary = properties.at("right_boundary").id();
  if (const auto left = properties.find("left_lane")) lane.left_lane = left->id();
  if (const auto right = properties.find("right_lane")) lane.right_lane = right->id();
  for (const JsonPlace& next : properties.at("successors").items()) lane.successors.push_back(next.id());
  return lane;
}

}  // namespace

RoadMap read_geojson(const std::filesystem::path& path) {
  const Json json = parse(path);
  const JsonPlace root(json, path.string());
  if (root.at("type").text() != "FeatureCollection") throw root.error("is no FeatureCollection");
  RoadMap map;
  map.origin = read_place(root.at("origin"));
  if (const auto name = root.find("name")) map.name = name->text();
  const GeoFrame frame(*map.origin);
  for (const JsonPlace& feature : root.at("features").items()) {
    const JsonPlace properties = feature.at("properties");
    const std::string element = properties.at("element").text();
    if (element == "boundary") map.boundaries.push_back(read_boundary(properties, feature, frame));
    if (element == "lane") map.lanes.push_back(read_lane(properties));
  }
  check(map, path.string());
  return map;
}

}  // namespace lanefuse
