// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "roadmap/lane_strips.hpp"
#include "roadmap/lanelet2.hpp"
#include "roadmap/osm_elements.hpp"

namespace lanefuse {
namespace {

constexpr std::size_t kMostSuccessors = 100;

using Tags = std::map<std::string, std::string>;

std::string value_of(const Tags& tags, const char* key) {
  const auto found = tags.find(key);
  return found == tags.end() ? "" : found->second;
}

MarkingStyle style_of(const XmlElement& way) {
  const Tags tags = osm_tags(way);
  const std::string type = value_of(tags, "type");
  const std::string subtype = value_of(tags, "subtype");
  const std::string colour = value_of(tags, "color");
  MarkingStyle style;
  const bool is_line = type == "line_thin" || type == "line_thick";
  style.width = is_line ? (type == "line_thick" ? 0.30 : 0.15) : 0;
  if (is_line && subtype.find("solid") != std::string::npos) style.marking.type = MarkingType::solid;
  if (is_line && (subtype == "dashed" || subtype == "dashed_dashed"))
    style.marking.type = MarkingType::dashed;
  if (type == "curbstone" || type == "road_border") style.marking.type = MarkingType::road_edge;
  if (type == "guard_rail" || type == "wall" || type == "fence") style.marking.type = MarkingType::guard_rail;
  if (colour == "white") style.marking.colour = MarkingColour::white;
  if (colour == "yellow") style.marking.colour = MarkingColour::yellow;
  const auto width = tags.find("width");
  if (width == tags.end()) return style;
  const std::optional<double> paint = parse_finite(width->second);
  if (!paint || *paint < 0 || *paint > 2) throw way.error("tag 'width' is no width of paint from 0 to 2 m");
  style.width = *paint;
  return style;
}

LaneKind kind_of(const Tags& tags) {
  const std::string subtype = value_of(tags, "subtype");
  const std::string kind = value_of(tags, "lane_kind");
  if (kind == "entry") return LaneKind::entry;
  if (kind == "other") return LaneKind::other;
  if (subtype == "emergency_lane") return LaneKind::emergency;
  if (subtype == "exit") return LaneKind::exit;
  const std::set<std::string> drivable = {"", "road", "highway", "play_street"};
  return drivable.contains(subtype) ? LaneKind::driving : LaneKind::other;
}

/// A lanelet's bound, turned into its driving direction.
struct Bound {
  std::int64_t way = 0;
  bool is_reversed = false;
  std::int64_t first_node = 0;
  std::int64_t last_node = 0;
};

struct Lanelet {
  XmlElement element;
  LaneStrip strip;
  Bound left;
  Bound right;
};

double turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.x() * b.y() - a.y() * b.x(); }

void turn_round(StripEdge& edge, Bound& bound) {
  std::reverse(edge.points.begin(), edge.points.end());
  std::swap(bound.first_node, bound.last_node);
  bound.is_reversed = !bound.is_reversed;
}

/// Ways may point either way: both bounds go the same way, and the left one lies to the left.
void align(Lanelet& lanelet) {
  StripEdge& left = lanelet.strip.edge(StripSide::left);
  StripEdge& right = lanelet.strip.edge(StripSide::right);
  const auto gap = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm(); };
  const double parallel =
      gap(left.points.front(), right.points.front()) + gap(left.points.back(), right.points.back());
  const double crossed =
      gap(left.points.front(), right.points.back()) + gap(left.points.back(), right.points.front());
  if (crossed < parallel) turn_round(right, lanelet.right);
  // the area of the way up on the left and back down on the right is below 0 where left lies to the left
  std::vector<Eigen::Vector3d> ring = left.points;
  ring.insert(ring.end(), right.points.rbegin(), right.points.rend());
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    area += turn(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  }
  if (area <= 0) return;
  turn_round(left, lanelet.left);
  turn_round(right, lanelet.right);
}

class LaneletReader {
 public:
  explicit LaneletReader(const XmlElement& root) : osm_(root) {
    std::set<std::int64_t> ids;
    for (const XmlElement& relation : root.children("relation")) {
      const Tags tags = osm_tags(relation);
      if (value_of(tags, "type") != "lanelet") continue;
      if (!ids.insert(relation.integer("id")).second) throw relation.error("has the id of another lanelet");
      add(relation, tags);
    }
  }

  RoadMap map() {
    tie_neighbours();
    tie_successors();
    std::vector<LaneStrip> strips;
    for (Lanelet& lanelet : lanelets_) strips.push_back(std::move(lanelet.strip));
    RoadMap map = join_strips(strips);
    map.origin = osm_.origin();
    return map;
  }

  [[nodiscard]] bool is_empty() const { return lanelets_.empty(); }

 private:
  void add(const XmlElement& relation, const Tags& tags) {
    Lanelet lanelet{relation, {}, {}, {}};
    const std::int64_t id = relation.integer("id");
    if (id <= 0) throw relation.error("has an id below 1");
    lanelet.strip.id = static_cast<std::uint64_t>(id);
    lanelet.strip.kind = kind_of(tags);
    lanelet.left = read_bound(relation, "left", lanelet.strip.edge(StripSide::left));
    lanelet.right = read_bound(relation, "right", lanelet.strip.edge(StripSide::right));
    align(lanelet);
    lanelets_.push_back(std::move(lanelet));
  }

  Bound read_bound(const XmlElement& relation, const std::string& role, StripEdge& edge) {
    std::optional<Bound> bound;
    for (const XmlElement& member : relation.children("member")) {
      if (member.find_text("role") != role) continue;
      if (bound) throw member.error(fmt::format("is a second {} bound", role), "join the ways to one");
      const std::int64_t id = member.integer("ref");
      const OsmElements::Way& way = osm_.way(id, member);
      take_points(way, member);
      edge = {without_repeats(way.points), {style_of(way.element)}};
      if (edge.points.size() < 2) throw way.element.error("has fewer than two different points");
      bound = Bound{id, false, way.nodes.front(), way.nodes.back()};
    }
    if (!bound) throw relation.error(fmt::format("has no member with the role '{}'", role));
    return *bound;
  }

  /// Any number of lanelets may share a way, and each has its points for itself.
  void take_points(const OsmElements::Way& way, const XmlElement& member) {
    if (way.points.size() > points_left_) {
      throw member.error(fmt::format("brings the lanes to more than {} points", kMostLanePoints),
                         "cut the map into smaller ones");
    }
    points_left_ -= way.points.size();
  }

  /// The one's right bound is the other's left, driven the same way.
  void tie_neighbours() {
    std::map<std::pair<std::int64_t, bool>, std::size_t> by_left;
    for (std::size_t i = 0; i < lanelets_.size(); ++i) {
      by_left.try_emplace({lanelets_[i].left.way, lanelets_[i].left.is_reversed}, i);
    }
    for (std::size_t i = 0; i < lanelets_.size(); ++i) {
      const auto found = by_left.find({lanelets_[i].right.way, lanelets_[i].right.is_reversed});
      if (found == by_left.end() || found->second == i) continue;
      lanelets_[i].strip.right_strip = found->second;
      lanelets_[found->second].strip.left_strip = i;
    }
  }

  void tie_successors() {
    std::multimap<std::pair<std::int64_t, std::int64_t>, std::size_t> by_begin;
    for (std::size_t i = 0; i < lanelets_.size(); ++i) {
      by_begin.emplace(std::pair(lanelets_[i].left.first_node, lanelets_[i].right.first_node), i);
    }
    for (Lanelet& lanelet : lanelets_) {
      const auto [from, to] = by_begin.equal_range({lanelet.left.last_node, lanelet.right.last_node});
      for (auto next = from; next != to; ++next) lanelet.strip.successors.push_back(next->second);
      if (lanelet.strip.successors.size() > kMostSuccessors) {
        throw lanelet.element.error(fmt::format("is followed by more than {} lanelets", kMostSuccessors));
      }
    }
  }

  OsmElements osm_;
  std::vector<Lanelet> lanelets_;
  std::size_t points_left_ = kMostLanePoints;
};

}  // namespace

RoadMap read_lanelet2(const std::filesystem::path& path) {
  const XmlFile file(path);
  const XmlElement root = file.root();
  if (root.name() != "osm") throw root.error("is no <osm>");
  LaneletReader reader(root);
  if (reader.is_empty()) {
    throw root.error("has no relation of type lanelet", "plain OpenStreetMap data has no lanes' boundaries");
  }
  RoadMap map = reader.map();
  check(map, file.file());
  return map;
}

}  // namespace lanefuse
