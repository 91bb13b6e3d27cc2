// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/commonroad.hpp"

#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "roadmap/commonroad_vehicles.hpp"
#include "roadmap/lane_strips.hpp"
#include "roadmap/xml_element.hpp"

namespace lanefuse {
namespace {

constexpr double kBroad = 0.30;     // [m] of paint
constexpr double kStandard = 0.15;  // [m] of paint

MarkingStyle style_of(const XmlElement& bound) {
  const auto marking = bound.find("lineMarking");
  const std::string name = marking ? marking->content() : "unknown";
  if (name == "solid" || name == "solid_solid") return {0, {MarkingType::solid, {}}, kStandard};
  if (name == "broad_solid") return {0, {MarkingType::solid, {}}, kBroad};
  if (name == "dashed" || name == "dashed_dashed") return {0, {MarkingType::dashed, {}}, kStandard};
  if (name == "broad_dashed") return {0, {MarkingType::dashed, {}}, kBroad};
  if (name == "solid_dashed" || name == "dashed_solid") return {0, {MarkingType::solid, {}}, kStandard};
  if (name == "curb" || name == "lowered_curb") return {0, {MarkingType::road_edge, {}}, 0};
  if (name == "no_marking") return {0, {}, 0};
  if (name == "unknown") return {0, {}, kStandard};
  throw marking->error(fmt::format("'{}' is no line marking of CommonRoad's", name.substr(0, 40)));
}

StripEdge read_bound(const XmlElement& bound) {
  StripEdge edge{{}, {style_of(bound)}};
  for (const XmlElement& point : bound.children("point")) {
    const auto height = point.find("z");
    edge.points.emplace_back(point.child("x").content_number(), point.child("y").content_number(),
                             height ? height->content_number() : 0);
  }
  edge.points = without_repeats(edge.points);
  if (edge.points.size() < 2) throw bound.error("has fewer than two different points");
  return edge;
}

LaneKind kind_of(const XmlElement& lanelet) {
  LaneKind kind = LaneKind::driving;
  for (const XmlElement& type : lanelet.children("laneletType")) {
    const std::string name = type.content();
    if (name == "shoulder") kind = LaneKind::emergency;
    if (name == "accessRamp") kind = LaneKind::entry;
    if (name == "exitRamp") kind = LaneKind::exit;
    if (name == "sidewalk" || name == "bicycleLane" || name == "crosswalk" || name == "busStop")
      return LaneKind::other;
  }
  return kind;
}

/// Makes strips of the lanelets.
class LaneletReader {
 public:
  explicit LaneletReader(const XmlElement& root) : elements_(root.children("lanelet")) {
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const std::int64_t id = elements_[i].integer("id");
      if (id <= 0) throw elements_[i].error("has an id below 1");
      if (!index_.try_emplace(id, i).second) throw elements_[i].error("has the id of another lanelet");
    }
  }

  [[nodiscard]] std::vector<LaneStrip> strips() const {
    std::vector<LaneStrip> strips;
    strips.reserve(elements_.size());
    for (const XmlElement& element : elements_) strips.push_back(strip(element));
    return strips;
  }

 private:
  [[nodiscard]] LaneStrip strip(const XmlElement& element) const {
    LaneStrip strip;
    strip.id = static_cast<std::uint64_t>(element.integer("id"));
    strip.kind = kind_of(element);
    strip.edge(StripSide::left) = read_bound(element.child("leftBound"));
    strip.edge(StripSide::right) = read_bound(element.child("rightBound"));
    strip.left_strip = neighbour(element, "adjacentLeft");
    strip.right_strip = neighbour(element, "adjacentRight");
    for (const XmlElement& successor : element.children("successor")) {
      strip.successors.push_back(referred(successor));
    }
    return strip;
  }

  [[nodiscard]] std::optional<std::size_t> neighbour(const XmlElement& element, const char* name) const {
    const auto beside = element.find(name);
    if (!beside) return std::nullopt;
    const std::size_t index = referred(*beside);
    const std::string direction = beside->text("drivingDir");
    if (direction != "same" && direction != "opposite") {
      throw beside->error("attribute 'drivingDir' is neither 'same' nor 'opposite'");
    }
    return direction == "same" ? std::optional(index) : std::nullopt;
  }

  [[nodiscard]] std::size_t referred(const XmlElement& reference) const {
    const auto found = index_.find(reference.integer("ref"));
    if (found == index_.end()) {
      throw reference.error(fmt::format("refers to lanelet {}, which is not there", reference.text("ref")));
    }
    return found->second;
  }

  std::vector<XmlElement> elements_;
  std::unordered_map<std::int64_t, std::size_t> index_;
};

/// Where a scenario's place is not known, its latitude is 999.
std::optional<GeoOrigin> read_origin(const XmlElement& root) {
  const auto location = root.find("location");
  if (!location || location->find("geoTransformation")) return std::nullopt;
  const auto latitude = location->find("gpsLatitude");
  const auto longitude = location->find("gpsLongitude");
  if (!latitude || !longitude) return std::nullopt;
  const GeoOrigin origin{latitude->content_number(), longitude->content_number(), 0};
  const bool known = std::abs(origin.latitude_deg) <= 90 && std::abs(origin.longitude_deg) <= 180;
  return known ? std::optional(origin) : std::nullopt;
}

double read_time_step(const XmlElement& root) {
  const double step = root.number("timeStepSize");
  if (step <= 0 || step > 100) throw root.error(fmt::format("attribute 'timeStepSize' is {}", step));
  return step;
}

void check_version(const XmlElement& root) {
  if (root.name() != "commonRoad") {
    throw root.error("is no <commonRoad>", "other maps in .xml are not read");
  }
  const std::string version = root.text("commonRoadVersion");
  if (version != "2018b" && version != "2020a") {
    throw root.error(fmt::format("is of version '{}'", version.substr(0, 40)), "2018b and 2020a are read");
  }
}

}  // namespace

CommonRoadScenario read_commonroad(const std::filesystem::path& path) {
  const XmlFile file(path);
  const XmlElement root = file.root();
  check_version(root);
  CommonRoadScenario scenario;
  scenario.time_step = read_time_step(root);
  scenario.map = join_strips(LaneletReader(root).strips());
  scenario.map.name = root.find_text("benchmarkID").value_or("");
  scenario.map.origin = read_origin(root);
  if (scenario.map.lanes.empty()) throw root.error("has no <lanelet>");
  check(scenario.map, file.file());
  scenario.vehicles = read_commonroad_vehicles(root, scenario.time_step);
  return scenario;
}

}  // namespace lanefuse
