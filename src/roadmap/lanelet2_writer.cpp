// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "roadmap/geo_frame.hpp"
#include "roadmap/lane_cuts.hpp"
#include "roadmap/lanelet2.hpp"
#include "roadmap/map_text.hpp"

namespace lanefuse {
namespace {

constexpr double kSameEnd = 0.05;  // [m] within which ends of ways are one node
constexpr double kThick = 0.2;     // [m] of paint

std::string tag(const char* key, const std::string& value) {
  return fmt::format("    <tag k=\"{}\" v=\"{}\"/>\n", key, xml_escaped(value));
}

std::string style_tags(const MarkingStyle& style) {
  const std::string line = style.width > kThick ? "line_thick" : "line_thin";
  std::string tags;
  switch (style.marking.type) {
    case MarkingType::unknown:
      tags = tag("type", style.width > 0 ? line : "virtual");
      break;
    case MarkingType::solid:
      tags = tag("type", line) + tag("subtype", "solid");
      break;
    case MarkingType::dashed:
      tags = tag("type", line) + tag("subtype", "dashed");
      break;
    case MarkingType::road_edge:
      tags = tag("type", "road_border");
      break;
    case MarkingType::guard_rail:
      tags = tag("type", "guard_rail");
      break;
  }
  if (style.marking.colour == MarkingColour::white) tags += tag("color", "white");
  if (style.marking.colour == MarkingColour::yellow) tags += tag("color", "yellow");
  return tags + tag("width", fmt::format("{}", style.width));
}

std::string kind_tags(LaneKind kind) {
  switch (kind) {
    case LaneKind::driving:
      return tag("subtype", "highway");
    case LaneKind::emergency:
      return tag("subtype", "emergency_lane");
    case LaneKind::entry:
      return tag("subtype", "highway") + tag("lane_kind", "entry");
    case LaneKind::exit:
      return tag("subtype", "exit");
    case LaneKind::other:
      return tag("subtype", "road") + tag("lane_kind", "other");
  }
  return "";
}

/// Gathers nodes, ways and relations, which a file has in this order.
class OsmText {
 public:
  explicit OsmText(const RoadMap& map, const std::string& place) : map_(map), cuts_(map, place) {
    if (map.origin) frame_.emplace(*map.origin);
    for (const MapLane& lane : map.lanes) next_id_ = std::max(next_id_, lane.id + 1);
    if (map.origin) add_origin();
    for (const MapLane& lane : map.lanes) add_lane(lane);
  }

  [[nodiscard]] std::string text() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<osm version=\"0.6\" generator=\"lanefuse\">\n" +
           nodes_ + ways_ + relations_ + "</osm>\n";
  }

 private:
  void add_origin() {
    nodes_ += fmt::format("  <node id=\"{}\" version=\"1\" lat=\"{:.11f}\" lon=\"{:.11f}\">\n", next_id_++,
                          map_.origin->latitude_deg, map_.origin->longitude_deg);
    nodes_ += tag("local_origin", "yes") + tag("ele", fmt::format("{}", map_.origin->height)) + "  </node>\n";
  }

  void add_lane(const MapLane& lane) {
    std::uint64_t id = lane.id;
    for (const LanePiece& piece : cuts_.pieces(lane)) {
      const std::uint64_t left = way(piece.left);
      const std::uint64_t right = way(piece.right);
      relations_ += fmt::format("  <relation id=\"{}\" version=\"1\">\n", id);
      relations_ += fmt::format("    <member type=\"way\" ref=\"{}\" role=\"left\"/>\n", left);
      relations_ += fmt::format("    <member type=\"way\" ref=\"{}\" role=\"right\"/>\n", right);
      relations_ += tag("type", "lanelet") + kind_tags(lane.kind) + tag("location", "nonurban") +
                    tag("one_way", "yes") + tag("participant:vehicle", "yes") + "  </relation>\n";
      id = next_id_++;
    }
  }

  /// The piece's way, which is written when it is first asked for.
  std::uint64_t way(const BoundaryPiece& piece) {
    const auto [found, is_new] = way_ids_.try_emplace(piece, 0);
    if (!is_new) return found->second;
    const std::vector<Eigen::Vector3d> points = cuts_.line(piece.boundary).between(piece.from, piece.to);
    std::string references;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == points.size();
      references += fmt::format("    <nd ref=\"{}\"/>\n", is_end ? end_node(points[i]) : node(points[i]));
    }
    const std::uint64_t id = found->second = next_id_++;
    const double middle = (piece.from + piece.to) / 2;
    ways_ += fmt::format("  <way id=\"{}\" version=\"1\">\n", id) + references +
             style_tags(style_at(*find_boundary(map_, piece.boundary), middle)) + "  </way>\n";
    return id;
  }

  /// Ways that meet share the node there.
  std::uint64_t end_node(const Eigen::Vector3d& point) {
    for (const auto& [there, id] : end_nodes_) {
      if ((there - point).norm() <= kSameEnd) return id;
    }
    end_nodes_.emplace_back(point, node(point));
    return end_nodes_.back().second;
  }

  std::uint64_t node(const Eigen::Vector3d& point) {
    const GeoOrigin place = frame_ ? frame_->place(point) : GeoOrigin{0, 0, point.z()};
    nodes_ += fmt::format("  <node id=\"{}\" version=\"1\" lat=\"{:.11f}\" lon=\"{:.11f}\">\n", next_id_,
                          place.latitude_deg, place.longitude_deg);
    nodes_ += tag("local_x", fmt::format("{:.4f}", point.x())) +
              tag("local_y", fmt::format("{:.4f}", point.y())) +
              tag("ele", fmt::format("{:.4f}", place.height)) + "  </node>\n";
    return next_id_++;
  }

  const RoadMap& map_;
  LaneCuts cuts_;
  std::optional<GeoFrame> frame_;
  std::uint64_t next_id_ = 1;
  std::map<BoundaryPiece, std::uint64_t> way_ids_;
  std::vector<std::pair<Eigen::Vector3d, std::uint64_t>> end_nodes_;
  std::string nodes_;
  std::string ways_;
  std::string relations_;
};

}  // namespace

std::string lanelet2_text(const RoadMap& map) {
  const std::string place = map.name.empty() ? "the map" : map.name;
  check(map, place);
  return OsmText(map, place).text();
}

}  // namespace lanefuse
