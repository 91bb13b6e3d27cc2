// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "roadmap/opendrive_road.hpp"

namespace lanefuse {

/// A lane of one section of one road.
struct OpenDriveLaneKey {
  std::size_t road = 0;  ///< index
  std::size_t section = 0;
  std::int64_t lane = 0;
  friend auto operator<=>(const OpenDriveLaneKey&, const OpenDriveLaneKey&) = default;
};

/// Which lanes follow which in driving direction: from section to section, from road to road, through
/// junctions.
class OpenDriveLinks {
 public:
  /// Refuses roads with one id twice and links to what is not there.
  OpenDriveLinks(const XmlElement& root, const std::vector<OpenDriveRoad>& roads);

  [[nodiscard]] std::vector<OpenDriveLaneKey> successors(const OpenDriveLaneKey& key) const;

 private:
  /// One lane of a junction's connection.
  struct JunctionLink {
    std::size_t incoming_road = 0;
    std::int64_t from = 0;
    OpenDriveLaneKey to;
  };

  void read_junction(const XmlElement& junction);
  void read_connection(const XmlElement& connection, std::vector<JunctionLink>& links);
  [[nodiscard]] std::size_t road_of(const XmlElement& element, const char* attribute) const;
  [[nodiscard]] std::size_t section_at(std::size_t road, const XmlElement& element) const;
  void check_lane(const OpenDriveLaneKey& key, const XmlElement& element) const;
  void add_lane_links(const OpenDriveLane& lane, bool at_end, std::size_t road, std::size_t section,
                      std::vector<OpenDriveLaneKey>& found) const;
  [[nodiscard]] std::vector<OpenDriveLaneKey> beyond_road(const OpenDriveLaneKey& key, bool at_end) const;

  const std::vector<OpenDriveRoad>& roads_;
  std::map<std::string, std::size_t> road_index_;
  std::map<std::string, std::vector<JunctionLink>> junctions_;
};

}  // namespace lanefuse
