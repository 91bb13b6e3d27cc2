// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive_road.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace lanefuse {
namespace {

constexpr double kLongestRoad = 1e6;  // [m]
constexpr double kWidestPaint = 2;    // [m]
constexpr double kStandard = 0.15;    // [m] of paint
constexpr double kBold = 0.30;        // [m] of paint

std::optional<LaneKind> kind_of(const std::string& type) {
  static const std::map<std::string, LaneKind> kinds = {{"driving", LaneKind::driving},
                                                        {"bidirectional", LaneKind::driving},
                                                        {"HOV", LaneKind::driving},
                                                        {"slipLane", LaneKind::driving},
                                                        {"stop", LaneKind::emergency},
                                                        {"shoulder", LaneKind::emergency},
                                                        {"entry", LaneKind::entry},
                                                        {"onRamp", LaneKind::entry},
                                                        {"exit", LaneKind::exit},
                                                        {"offRamp", LaneKind::exit},
                                                        {"connectingRamp", LaneKind::driving},
                                                        {"biking", LaneKind::other},
                                                        {"sidewalk", LaneKind::other},
                                                        {"walking", LaneKind::other},
                                                        {"parking", LaneKind::other},
                                                        {"restricted", LaneKind::other},
                                                        {"roadWorks", LaneKind::other},
                                                        {"bus", LaneKind::other},
                                                        {"taxi", LaneKind::other},
                                                        {"tram", LaneKind::other},
                                                        {"rail", LaneKind::other},
                                                        {"special1", LaneKind::other},
                                                        {"special2", LaneKind::other},
                                                        {"special3", LaneKind::other},
                                                        {"mwyEntry", LaneKind::entry},
                                                        {"mwyExit", LaneKind::exit}};
  const auto found = kinds.find(type);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

/// Of a double line, the one that a lane on its inner side sees does not matter here: any solid one is solid.
MarkingType marking_type(const XmlElement& mark) {
  const std::string type = mark.text("type");
  if (type.find("solid") != std::string::npos) return MarkingType::solid;
  if (type.find("broken") != std::string::npos || type == "botts dots") return MarkingType::dashed;
  if (type == "curb" || type == "edge" || type == "grass") return MarkingType::road_edge;
  const auto detail = mark.find("type");
  if (detail && detail->find_text("name") == "guard_rail") return MarkingType::guard_rail;
  if (type == "none" || type == "custom") return MarkingType::unknown;
  throw mark.error(fmt::format("'{}' is no type of road mark", type.substr(0, 40)));
}

MarkingColour marking_colour(const std::string& colour) {
  if (colour == "yellow") return MarkingColour::yellow;
  return colour == "white" || colour == "standard" ? MarkingColour::white : MarkingColour::unknown;
}

MarkingStyle read_mark(const XmlElement& mark) {
  MarkingStyle style;
  style.from = std::max(0.0, mark.number("sOffset", 0));
  style.marking.type = marking_type(mark);
  const bool is_paint = style.marking.type == MarkingType::solid || style.marking.type == MarkingType::dashed;
  const auto colour = mark.find_text("color");
  if (colour) style.marking.colour = marking_colour(*colour);
  if (!is_paint && colour == "standard") style.marking.colour = MarkingColour::unknown;
  const double usual = mark.find_text("weight") == "bold" ? kBold : kStandard;
  style.width = mark.number("width", is_paint ? usual : 0);
  if (style.width < 0 || style.width > kWidestPaint) {
    throw mark.error(fmt::format("attribute 'width' is {}", style.width));
  }
  return style;
}

std::vector<MarkingStyle> read_marks(const XmlElement& lane) {
  std::vector<MarkingStyle> styles;
  for (const XmlElement& mark : lane.children("roadMark")) styles.push_back(read_mark(mark));
  std::stable_sort(styles.begin(), styles.end(),
                   [](const auto& a, const auto& b) { return a.from < b.from; });
  if (styles.empty() || styles.front().from > 0) styles.insert(styles.begin(), {0, {}, 0});
  return styles;
}

OpenDriveLane read_lane(const XmlElement& element) {
  OpenDriveLane lane{element, element.integer("id"), kind_of(element.text("type")), {}, false, {}};
  lane.extent = read_cubics(element, "width", "sOffset");
  if (lane.extent.pieces.empty()) {
    lane.extent = read_cubics(element, "border", "sOffset");
    lane.extent_is_border = !lane.extent.pieces.empty();
  }
  if (lane.id != 0 && lane.extent.pieces.empty()) throw element.error("has neither <width> nor <border>");
  lane.marks = read_marks(element);
  return lane;
}

void read_side(const XmlElement& section, const char* side, int sign, std::vector<OpenDriveLane>& lanes) {
  const auto element = section.find(side);
  if (!element) return;
  for (const XmlElement& lane : element->children("lane")) {
    lanes.push_back(read_lane(lane));
    const std::int64_t id = lanes.back().id;
    if ((id > 0) - (id < 0) != sign) throw lane.error(fmt::format("has an id that is none for <{}>", side));
  }
}

OpenDriveSection read_section(const XmlElement& element) {
  OpenDriveSection section{element, element.number("s"), 0, {}};
  read_side(element, "left", 1, section.lanes);
  read_side(element, "center", 0, section.lanes);
  read_side(element, "right", -1, section.lanes);
  std::stable_sort(section.lanes.begin(), section.lanes.end(),
                   [](const auto& a, const auto& b) { return a.id > b.id; });
  for (std::size_t i = 1; i < section.lanes.size(); ++i) {
    if (section.lanes[i].id == section.lanes[i - 1].id) {
      throw section.lanes[i].element.error("has the id of another lane of its section");
    }
    if (section.lanes[i].id < section.lanes[i - 1].id - 1) {
      throw section.lanes[i].element.error(
          fmt::format("has no lane {} between it and the centre", section.lanes[i - 1].id - 1));
    }
  }
  const bool has_centre = std::any_of(section.lanes.begin(), section.lanes.end(),
                                      [](const OpenDriveLane& lane) { return lane.id == 0; });
  if (!has_centre) throw element.error("has no lane 0 in <center>");
  return section;
}

std::vector<OpenDriveSection> read_sections(const XmlElement& lanes, double length) {
  std::vector<OpenDriveSection> sections;
  for (const XmlElement& element : lanes.children("laneSection")) {
    sections.push_back(read_section(element));
    const double from = sections.back().from;
    const double before = sections.size() > 1 ? (sections.end() - 2)->from : 0;
    if (from < before || from > length) throw element.error(fmt::format("begins at s = {}", from));
    if (sections.size() > 1) (sections.end() - 2)->to = from;
  }
  if (sections.empty()) throw lanes.error("has no <laneSection>");
  sections.back().to = length;
  return sections;
}

double read_length(const XmlElement& road) {
  const double length = road.number("length");
  if (length <= 0 || length > kLongestRoad) throw road.error(fmt::format("attribute 'length' is {}", length));
  return length;
}

}  // namespace

OpenDriveRoad read_opendrive_road(const XmlElement& road) {
  const double length = read_length(road);
  const XmlElement lanes = road.child("lanes");
  const auto profile = road.find("elevationProfile");
  return {road,
          road.text("id"),
          length,
          road.find_text("rule") == "LHT",
          read_plan_view(road.child("planView"), length),
          profile ? read_cubics(*profile, "elevation", "s") : CubicTable{},
          read_cubics(lanes, "laneOffset", "s"),
          read_sections(lanes, length)};
}

}  // namespace lanefuse
