// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/osm_elements.hpp"

#include <cmath>

#include <fmt/format.h>

#include "roadmap/geo_frame.hpp"

namespace lanefuse {
namespace {

using Tags = std::map<std::string, std::string>;

struct Node {
  XmlElement element;
  GeoOrigin place;
  std::optional<Eigen::Vector2d> local;  ///< as tagged
  bool is_origin = false;
};

std::optional<double> length_tag(const XmlElement& node, const Tags& tags, const char* key) {
  const auto found = tags.find(key);
  if (found == tags.end()) return std::nullopt;
  const std::optional<double> value = parse_finite(found->second);
  if (!value || std::abs(*value) > 1e9) {
    throw node.error(fmt::format("tag '{}' is '{}', which is no length", key, found->second.substr(0, 40)));
  }
  return value;
}

double degrees(const XmlElement& node, const char* attribute, double limit) {
  const double value = node.number(attribute, 0);
  if (std::abs(value) > limit) throw node.error(fmt::format("attribute '{}' is {}", attribute, value));
  return value;
}

Node read_node(const XmlElement& element) {
  const Tags tags = osm_tags(element);
  Node node{element, {degrees(element, "lat", 90), degrees(element, "lon", 180), 0}, {}, false};
  node.place.height = length_tag(element, tags, "ele").value_or(0);
  const auto x = length_tag(element, tags, "local_x");
  const auto y = length_tag(element, tags, "local_y");
  if (x && y) node.local = Eigen::Vector2d(*x, *y);
  const auto marked = tags.find("local_origin");
  node.is_origin = marked != tags.end() && marked->second == "yes";
  return node;
}

std::optional<GeoOrigin> origin_of(const std::vector<Node>& nodes) {
  for (const Node& node : nodes) {
    if (node.is_origin) return node.place;
  }
  for (const Node& node : nodes) {
    if (node.place.latitude_deg == 0 && node.place.longitude_deg == 0) continue;
    return GeoOrigin{nodes.front().place.latitude_deg, nodes.front().place.longitude_deg, 0};
  }
  return std::nullopt;
}

Eigen::Vector3d local_point(const Node& node) {
  if (!node.local) throw node.element.error("has neither a place on Earth nor the tags local_x and local_y");
  return {node.local->x(), node.local->y(), node.place.height};
}

}  // namespace

std::map<std::string, std::string> osm_tags(const XmlElement& element) {
  std::map<std::string, std::string> tags;
  for (const XmlElement& tag : element.children("tag")) tags[tag.text("k")] = tag.text("v");
  return tags;
}

OsmElements::OsmElements(const XmlElement& root) {
  read_nodes(root);
  read_ways(root);
}

void OsmElements::read_nodes(const XmlElement& root) {
  std::vector<Node> nodes;
  for (const XmlElement& element : root.children("node")) nodes.push_back(read_node(element));
  origin_ = origin_of(nodes);
  const auto frame = origin_ ? std::optional<GeoFrame>(*origin_) : std::nullopt;
  for (const Node& node : nodes) {
    const Eigen::Vector3d point = frame ? frame->local(node.place) : local_point(node);
    if (!nodes_.try_emplace(node.element.integer("id"), point).second) {
      throw node.element.error("has the id of another node");
    }
  }
}

void OsmElements::read_ways(const XmlElement& root) {
  for (const XmlElement& element : root.children("way")) {
    Way way{element, {}, {}};
    for (const XmlElement& reference : element.children("nd")) {
      const auto found = nodes_.find(reference.integer("ref"));
      if (found == nodes_.end()) {
        throw reference.error(fmt::format("refers to node {}, which is not there", reference.text("ref")));
      }
      way.nodes.push_back(found->first);
      way.points.push_back(found->second);
    }
    if (!ways_.try_emplace(element.integer("id"), std::move(way)).second) {
      throw element.error("has the id of another way");
    }
  }
}

const OsmElements::Way& OsmElements::way(std::int64_t id, const XmlElement& reference) const {
  const auto found = ways_.find(id);
  if (found == ways_.end()) throw reference.error(fmt::format("refers to way {}, which is not there", id));
  return found->second;
}

}  // namespace lanefuse
