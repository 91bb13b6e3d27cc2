// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "roadmap/road_map.hpp"
#include "roadmap/xml_element.hpp"

namespace lanefuse {

/// Nodes, ways and tags of an OpenStreetMap file, with nodes in a map's frame.
class OsmElements {
 public:
  explicit OsmElements(const XmlElement& root);

  struct Way {
    XmlElement element;
    std::vector<std::int64_t> nodes;
    std::vector<Eigen::Vector3d> points;
  };
  /// Throws, naming `reference`, if there is no such way.
  [[nodiscard]] const Way& way(std::int64_t id, const XmlElement& reference) const;
  [[nodiscard]] const std::optional<GeoOrigin>& origin() const { return origin_; }

 private:
  void read_nodes(const XmlElement& root);
  void read_ways(const XmlElement& root);

  std::optional<GeoOrigin> origin_;
  std::unordered_map<std::int64_t, Eigen::Vector3d> nodes_;
  std::unordered_map<std::int64_t, Way> ways_;
};

/// The values of an element's <tag> children by their keys.
std::map<std::string, std::string> osm_tags(const XmlElement& element);

}  // namespace lanefuse
