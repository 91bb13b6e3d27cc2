// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive_links.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace lanefuse {
namespace {

const OpenDriveLane* find(const OpenDriveSection& section, std::int64_t id) {
  const auto found = std::find_if(section.lanes.begin(), section.lanes.end(),
                                  [id](const OpenDriveLane& lane) { return lane.id == id; });
  return found == section.lanes.end() ? nullptr : &*found;
}

std::optional<XmlElement> road_link(const OpenDriveRoad& road, bool at_end) {
  const auto link = road.element.find("link");
  return link ? link->find(at_end ? "successor" : "predecessor") : std::nullopt;
}

}  // namespace

OpenDriveLinks::OpenDriveLinks(const XmlElement& root, const std::vector<OpenDriveRoad>& roads)
    : roads_(roads) {
  for (std::size_t i = 0; i < roads.size(); ++i) {
    if (!road_index_.try_emplace(roads[i].id, i).second)
      throw roads[i].element.error("has the id of another road");
  }
  for (const XmlElement& junction : root.children("junction")) read_junction(junction);
}

std::size_t OpenDriveLinks::road_of(const XmlElement& element, const char* attribute) const {
  const auto found = road_index_.find(element.text(attribute));
  if (found == road_index_.end()) {
    throw element.error(fmt::format("refers to road '{}', which is not there", element.text(attribute)));
  }
  return found->second;
}

/// The section that touches at the element's contact point.
std::size_t OpenDriveLinks::section_at(std::size_t road, const XmlElement& element) const {
  const std::string contact = element.text("contactPoint");
  if (contact != "start" && contact != "end") {
    throw element.error("attribute 'contactPoint' is neither 'start' nor 'end'");
  }
  return contact == "start" ? 0 : roads_[road].sections.size() - 1;
}

void OpenDriveLinks::check_lane(const OpenDriveLaneKey& key, const XmlElement& element) const {
  if (find(roads_[key.road].sections[key.section], key.lane)) return;
  throw element.error(
      fmt::format("refers to lane {} of road '{}', which is not there", key.lane, roads_[key.road].id));
}

void OpenDriveLinks::read_junction(const XmlElement& junction) {
  const auto [found, is_new] = junctions_.try_emplace(junction.text("id"));
  if (!is_new) throw junction.error("has the id of another junction");
  for (const XmlElement& connection : junction.children("connection"))
    read_connection(connection, found->second);
}

void OpenDriveLinks::read_connection(const XmlElement& connection, std::vector<JunctionLink>& links) {
  if (!connection.find("laneLink")) return;
  const std::size_t incoming = road_of(connection, "incomingRoad");
  const bool is_direct = connection.find_text("linkedRoad").has_value();
  const std::size_t road = road_of(connection, is_direct ? "linkedRoad" : "connectingRoad");
  const std::size_t section = section_at(road, connection);
  for (const XmlElement& link : connection.children("laneLink")) {
    const OpenDriveLaneKey to{road, section, link.integer("to")};
    check_lane(to, link);
    links.push_back({incoming, link.integer("from"), to});
  }
}

void OpenDriveLinks::add_lane_links(const OpenDriveLane& lane, bool at_end, std::size_t road,
                                    std::size_t section, std::vector<OpenDriveLaneKey>& found) const {
  const auto links = lane.element.find("link");
  if (!links) return;
  for (const XmlElement& link : links->children(at_end ? "successor" : "predecessor")) {
    found.push_back({road, section, link.integer("id")});
    check_lane(found.back(), link);
  }
}

std::vector<OpenDriveLaneKey> OpenDriveLinks::beyond_road(const OpenDriveLaneKey& key, bool at_end) const {
  std::vector<OpenDriveLaneKey> found;
  const OpenDriveRoad& road = roads_[key.road];
  const auto link = road_link(road, at_end);
  if (!link) return found;
  if (link->text("elementType") == "road") {
    const std::size_t other = road_of(*link, "elementId");
    add_lane_links(*find(road.sections[key.section], key.lane), at_end, other, section_at(other, *link),
                   found);
    return found;
  }
  const auto junction = junctions_.find(link->text("elementId"));
  if (junction == junctions_.end()) {
    throw link->error(fmt::format("refers to junction '{}', which is not there", link->text("elementId")));
  }
  for (const JunctionLink& connection : junction->second) {
    if (connection.incoming_road == key.road && connection.from == key.lane) found.push_back(connection.to);
  }
  return found;
}

std::vector<OpenDriveLaneKey> OpenDriveLinks::successors(const OpenDriveLaneKey& key) const {
  const OpenDriveRoad& road = roads_[key.road];
  const bool forward = road.is_forward(key.lane);
  const bool is_outermost = forward ? key.section + 1 == road.sections.size() : key.section == 0;
  if (is_outermost) return beyond_road(key, forward);
  std::vector<OpenDriveLaneKey> found;
  add_lane_links(*find(road.sections[key.section], key.lane), forward, key.road,
                 forward ? key.section + 1 : key.section - 1, found);
  return found;
}

}  // namespace lanefuse
