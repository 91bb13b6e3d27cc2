// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "roadmap/opendrive.hpp"
#include "roadmap/opendrive_frame.hpp"
#include "roadmap/opendrive_links.hpp"
#include "roadmap/opendrive_strips.hpp"

namespace lanefuse {
namespace {

std::vector<OpenDriveRoad> read_roads(const XmlElement& root) {
  std::vector<OpenDriveRoad> roads;
  for (const XmlElement& road : root.children("road")) roads.push_back(read_opendrive_road(road));
  if (roads.empty()) throw root.error("has no <road>");
  return roads;
}

/// All roads' strips, and where each lane's strip is.
class Strips {
 public:
  void add_section(const OpenDriveRoad& road, std::size_t road_index, std::size_t section,
                   const PointConversion& convert) {
    const std::size_t first = strips_.size();
    for (OpenDriveStrip& made : sample_section(road, section, convert, points_left_)) {
      LaneStrip& strip = strips_.emplace_back(std::move(made.strip));
      strip.id = strips_.size();
      if (strip.left_strip) *strip.left_strip += first;
      if (strip.right_strip) *strip.right_strip += first;
      keys_.push_back({road_index, section, made.lane});
      index_.emplace(keys_.back(), strips_.size() - 1);
    }
  }

  void link(const OpenDriveLinks& links, const std::vector<OpenDriveRoad>& roads) {
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      for (const OpenDriveLaneKey& next : links.successors(keys_[i])) {
        const auto found = index_.find(next);
        if (found != index_.end() && is_entered(keys_[i], next, roads))
          strips_[i].successors.push_back(found->second);
      }
    }
  }

  [[nodiscard]] const std::vector<LaneStrip>& all() const { return strips_; }

 private:
  /// From road to road a lane must be entered where its driving direction begins.
  static bool is_entered(const OpenDriveLaneKey& from, const OpenDriveLaneKey& to,
                         const std::vector<OpenDriveRoad>& roads) {
    const OpenDriveRoad& road = roads[to.road];
    if (from.road == to.road && from.section != to.section) {
      return roads[from.road].is_forward(from.lane) == road.is_forward(to.lane);
    }
    return to.section == (road.is_forward(to.lane) ? 0 : road.sections.size() - 1);
  }

  std::vector<LaneStrip> strips_;
  std::vector<OpenDriveLaneKey> keys_;
  std::map<OpenDriveLaneKey, std::size_t> index_;
  std::size_t points_left_ = kMostLanePoints;
};

}  // namespace

RoadMap read_opendrive(const std::filesystem::path& path) {
  const XmlFile file(path);
  const XmlElement root = file.root();
  if (root.name() != "OpenDRIVE") throw root.error("is no <OpenDRIVE>");
  const std::vector<OpenDriveRoad> roads = read_roads(root);
  const OpenDriveLinks links(root, roads);
  const OpenDriveFrame frame = read_opendrive_frame(root, roads.front().plan.pose(0).position());
  Strips strips;
  for (std::size_t road = 0; road < roads.size(); ++road) {
    for (std::size_t section = 0; section < roads[road].sections.size(); ++section) {
      strips.add_section(roads[road], road, section, frame.local);
    }
  }
  strips.link(links, roads);
  RoadMap map = join_strips(strips.all());
  const auto header = root.find("header");
  map.name = header ? header->find_text("name").value_or("") : "";
  map.origin = frame.origin;
  if (map.lanes.empty()) throw root.error("has no lane that vehicles use");
  check(map, file.file());
  return map;
}

}  // namespace lanefuse
