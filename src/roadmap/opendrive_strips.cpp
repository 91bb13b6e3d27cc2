// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive_strips.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace lanefuse {
namespace {

constexpr double kLongestStep = 2.0;     // [m]
constexpr double kChordError = 0.004;    // [m]
constexpr double kShortestStep = 0.02;   // [m]
constexpr double kNoWidth = 0.01;        // [m]
constexpr double kShortSection = 0.001;  // [m]

/// The edges of one section's lanes, by station.
class SectionEdges {
 public:
  SectionEdges(const OpenDriveRoad& road, const OpenDriveSection& section) : road_(road), section_(section) {
    for (std::size_t i = 0; i < section.lanes.size(); ++i) {
      if (section.lanes[i].id == 0) centre_ = i;
    }
  }

  /// The lateral offsets of each lane's outer edge (of the centre: itself), by the lane's place in the
  /// section.
  [[nodiscard]] std::vector<double> offsets(double station) const {
    std::vector<double> offsets(section_.lanes.size());
    offsets[centre_] = road_.lane_offset.at(station);
    for (std::size_t i = centre_; i-- > 0;) offsets[i] = outer(i, offsets[i + 1], station, 1);
    for (std::size_t i = centre_ + 1; i < offsets.size(); ++i)
      offsets[i] = outer(i, offsets[i - 1], station, -1);
    return offsets;
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> points(double station) const {
    const Pose2 pose = road_.plan.pose(station);
    const double height = road_.elevation.at(station);
    std::vector<Eigen::Vector3d> points;
    for (const double offset : offsets(station)) {
      const Eigen::Vector2d at = pose * Eigen::Vector2d(0, offset);
      points.emplace_back(at.x(), at.y(), height);
    }
    return points;
  }

  [[nodiscard]] std::size_t centre() const { return centre_; }

 private:
  [[nodiscard]] double outer(std::size_t lane, double inner, double station, int side) const {
    const OpenDriveLane& here = section_.lanes[lane];
    const double extent = here.extent.at(station - section_.from);
    if (here.extent_is_border) return side * std::abs(extent);
    return inner + side * std::max(0.0, extent);
  }

  const OpenDriveRoad& road_;
  const OpenDriveSection& section_;
  std::size_t centre_ = 0;
};

/// One station and the points of all edges there.
struct Slice {
  double station = 0;
  std::vector<Eigen::Vector3d> points;
};

/// Puts slices between two until all chords fit.
class Sampler {
 public:
  Sampler(const SectionEdges& edges, std::size_t& points_left, const XmlElement& place)
      : edges_(edges), points_left_(points_left), place_(place) {}

  std::vector<Slice> sample(const std::vector<double>& stations) {
    slices_ = {slice(stations.front())};
    for (std::size_t i = 1; i < stations.size(); ++i) refine_to(slice(stations[i]));
    return std::move(slices_);
  }

 private:
  Slice slice(double station) {
    Slice slice{station, edges_.points(station)};
    if (slice.points.size() > points_left_) {
      throw place_.error(fmt::format("brings the lanes to more than {} points", kMostLanePoints),
                         "cut the map into smaller ones");
    }
    points_left_ -= slice.points.size();
    return slice;
  }

  void refine_to(Slice to) {
    const Slice& from = slices_.back();
    const double step = to.station - from.station;
    if (step > 2 * kShortestStep) {
      Slice middle = slice((from.station + to.station) / 2);
      if (!fits(from, middle, to)) {
        refine_to(std::move(middle));
        refine_to(std::move(to));
        return;
      }
      points_left_ += middle.points.size();
    }
    slices_.push_back(std::move(to));
  }

  static bool fits(const Slice& from, const Slice& middle, const Slice& to) {
    for (std::size_t i = 0; i < middle.points.size(); ++i) {
      const Eigen::Vector2d chord = (to.points[i] - from.points[i]).head<2>();
      const Eigen::Vector2d there = (middle.points[i] - from.points[i]).head<2>();
      const double off = std::abs(chord.x() * there.y() - chord.y() * there.x());
      if (chord.norm() > kLongestStep || off > kChordError * chord.norm()) return false;
    }
    return true;
  }

  const SectionEdges& edges_;
  std::size_t& points_left_;
  const XmlElement& place_;
  std::vector<Slice> slices_;
};

/// Stations where something may bend, so that no chord cuts a corner.
std::vector<double> corner_stations(const OpenDriveRoad& road, const OpenDriveSection& section) {
  std::vector<double> stations = {section.from, section.to};
  const auto add = [&](double station) {
    if (station > section.from && station < section.to) stations.push_back(station);
  };
  for (const PlanElement& element : road.plan.elements()) add(element.station);
  for (const CubicTable* table : {&road.elevation, &road.lane_offset}) {
    for (const CubicTable::Piece& piece : table->pieces) add(piece.from);
  }
  for (const OpenDriveLane& lane : section.lanes) {
    for (const CubicTable::Piece& piece : lane.extent.pieces) add(section.from + piece.from);
  }
  std::sort(stations.begin(), stations.end());
  const auto last =
      std::unique(stations.begin(), stations.end(), [](double a, double b) { return b - a < kShortSection; });
  stations.erase(last, stations.end());
  stations.back() = section.to;
  return stations;
}

/// Steps short enough that a bend between three samples cannot hide.
std::vector<double> first_stations(const OpenDriveRoad& road, const OpenDriveSection& section) {
  std::vector<double> stations;
  const std::vector<double> corners = corner_stations(road, section);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double gap = corners[i] - corners[i - 1];
    const int steps = static_cast<int>(std::ceil(gap / kLongestStep));
    for (int step = 0; step < steps; ++step) stations.push_back(corners[i - 1] + gap * step / steps);
  }
  stations.push_back(corners.back());
  return stations;
}

/// One edge of the slices as a strip's, along the stations or against them.
class EdgeMaker {
 public:
  EdgeMaker(const OpenDriveSection& section, const std::vector<Slice>& slices, const PointConversion& convert)
      : section_(section), slices_(slices), convert_(convert) {}

  [[nodiscard]] StripEdge make(std::size_t lane, bool forward) const {
    StripEdge edge;
    for (const Slice& slice : slices_) edge.points.push_back(convert_(slice.points[lane]));
    edge.styles = section_.lanes[lane].marks;
    const double share = scale(lane);
    for (MarkingStyle& style : edge.styles) style.from *= share;
    if (!forward) turn_round(edge);
    edge.points = without_repeats(edge.points);
    if (edge.points.size() < 2)
      throw section_.lanes[lane].element.error("has an edge that shrinks to a point");
    return edge;
  }

 private:
  /// Marks count along the reference line, styles along the edge itself.
  [[nodiscard]] double scale(std::size_t lane) const {
    double length = 0;
    for (std::size_t i = 1; i < slices_.size(); ++i) {
      length += (slices_[i].points[lane] - slices_[i - 1].points[lane]).norm();
    }
    return length / (section_.to - section_.from);
  }

  static void turn_round(StripEdge& edge) {
    std::reverse(edge.points.begin(), edge.points.end());
    const double length = arc_length(edge.points);
    std::vector<MarkingStyle> turned;
    double from = 0;
    for (std::size_t i = edge.styles.size(); i-- > 0;) {
      MarkingStyle style = edge.styles[i];
      const double next = std::max(0.0, length - style.from);
      if (style.from >= length && edge.styles.size() > 1 && i > 0) continue;  // begins beyond the end
      style.from = from;
      from = next;
      turned.push_back(style);
    }
    edge.styles = turned;
  }

  const OpenDriveSection& section_;
  const std::vector<Slice>& slices_;
  const PointConversion& convert_;
};

bool has_width(const std::vector<Slice>& slices, std::size_t outer, std::size_t inner) {
  return std::any_of(slices.begin(), slices.end(), [&](const Slice& slice) {
    return (slice.points[outer] - slice.points[inner]).norm() > kNoWidth;
  });
}

/// Neighbours are driven the same way and touch.
void tie_neighbours(std::vector<OpenDriveStrip>& strips, const OpenDriveRoad& road,
                    const std::vector<std::pair<std::size_t, std::size_t>>& edges) {
  for (std::size_t i = 0; i + 1 < strips.size(); ++i) {
    const bool forward = road.is_forward(strips[i].lane);
    if (forward != road.is_forward(strips[i + 1].lane) || edges[i].second != edges[i + 1].first) continue;
    (forward ? strips[i].strip.right_strip : strips[i].strip.left_strip) = i + 1;
    (forward ? strips[i + 1].strip.left_strip : strips[i + 1].strip.right_strip) = i;
  }
}

}  // namespace

std::vector<OpenDriveStrip> sample_section(const OpenDriveRoad& road, std::size_t index,
                                           const PointConversion& convert, std::size_t& points_left) {
  const OpenDriveSection& section = road.sections[index];
  if (section.to - section.from < kShortSection) return {};
  const SectionEdges section_edges(road, section);
  const std::vector<Slice> slices =
      Sampler(section_edges, points_left, section.element).sample(first_stations(road, section));
  const EdgeMaker edge(section, slices, convert);
  std::vector<OpenDriveStrip> strips;
  std::vector<std::pair<std::size_t, std::size_t>>
      edges;  // of each strip, to the left and right of the stations
  for (std::size_t i = 0; i < section.lanes.size(); ++i) {
    const OpenDriveLane& lane = section.lanes[i];
    if (lane.id == 0 || !lane.kind) continue;
    const std::size_t inner = lane.id > 0 ? i + 1 : i - 1;
    if (!has_width(slices, i, inner)) continue;
    edges.emplace_back(std::min(i, inner), std::max(i, inner));
    const bool forward = road.is_forward(lane.id);
    OpenDriveStrip& made = strips.emplace_back(OpenDriveStrip{{}, index, lane.id});
    made.strip.kind = *lane.kind;
    made.strip.edge(StripSide::left) = edge.make(forward ? edges.back().first : edges.back().second, forward);
    made.strip.edge(StripSide::right) =
        edge.make(forward ? edges.back().second : edges.back().first, forward);
  }
  tie_neighbours(strips, road, edges);
  return strips;
}

}  // namespace lanefuse
