// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/lane_cuts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kNear = 1.0;  // [m]

}  // namespace

LaneCuts::LaneCuts(const RoadMap& map, const std::string& place) : place_(place) {
  for (const MapBoundary& boundary : map.boundaries) {
    const MeasuredLine& line = lines_.emplace(boundary.id, MeasuredLine(boundary.points)).first->second;
    cuts_[boundary.id] = {0, line.length()};
  }
  for (const MapLane& lane : map.lanes) {
    lanes_at_.emplace(lane.left_boundary, &lane);
    lanes_at_.emplace(lane.right_boundary, &lane);
  }
  for (const MapLane& lane : map.lanes) cut_at_lane_ends(lane);
  for (const MapBoundary& boundary : map.boundaries) {
    for (std::size_t i = 1; i < boundary.styles.size(); ++i) cut_across(boundary.id, boundary.styles[i].from);
  }
}

bool LaneCuts::is_near_cut(std::uint64_t boundary, double arc) const {
  return std::abs(snapped(boundary, arc) - arc) < kNear;
}

bool LaneCuts::is_near_end(std::uint64_t boundary, double arc) const {
  return arc < kNear || lines_.at(boundary).length() - arc < kNear;
}

double LaneCuts::snapped(std::uint64_t boundary, double arc) const {
  const std::set<double>& cuts = cuts_.at(boundary);
  const auto after = cuts.lower_bound(arc);
  if (after == cuts.begin()) return *after;
  if (after == cuts.end()) return *std::prev(after);
  return *after - arc < arc - *std::prev(after) ? *after : *std::prev(after);
}

/// Where one boundary of a lane ends beside the other, the other is cut.
void LaneCuts::cut_at_lane_ends(const MapLane& lane) {
  for (const auto& [ending, running] : {std::pair(lane.left_boundary, lane.right_boundary),
                                        std::pair(lane.right_boundary, lane.left_boundary)}) {
    const MeasuredLine& line = lines_.at(ending);
    for (const double end : {0.0, line.length()})
      cut_across(running, lines_.at(running).nearest(line.at(end)));
  }
}

/// The boundary, and every other that is reached over lanes, unless there is a cut nearby already.
void LaneCuts::cut_across(std::uint64_t boundary, double arc) {
  std::map<std::uint64_t, double> cut = {{boundary, arc}};
  std::vector<std::uint64_t> open = {boundary};
  while (!open.empty()) {
    const std::uint64_t at = open.back();
    open.pop_back();
    if (is_near_end(at, cut.at(at))) continue;  // lanes end here
    if (is_near_cut(at, cut.at(at))) return;    // everything is cut here already
    const auto [from, to] = lanes_at_.equal_range(at);
    for (auto lane = from; lane != to; ++lane) {
      const MapLane& here = *lane->second;
      const std::uint64_t other = here.left_boundary == at ? here.right_boundary : here.left_boundary;
      if (cut.contains(other)) continue;
      cut[other] = lines_.at(other).nearest(lines_.at(at).at(cut.at(at)));
      open.push_back(other);
    }
  }
  for (const auto& [id, at] : cut) {
    if (!is_near_cut(id, at)) cuts_[id].insert(at);
  }
}

/// The pieces of the boundary that lie beside the other one.
std::vector<BoundaryPiece> LaneCuts::side(std::uint64_t boundary, std::uint64_t other) const {
  const MeasuredLine& line = lines_.at(boundary);
  const MeasuredLine& beside = lines_.at(other);
  const double from = snapped(boundary, line.nearest(beside.at(0)));
  const double to = snapped(boundary, line.nearest(beside.at(beside.length())));
  std::vector<BoundaryPiece> pieces;
  const std::set<double>& cuts = cuts_.at(boundary);
  for (auto at = cuts.find(from); at != cuts.end() && std::next(at) != cuts.end() && *at < to; ++at) {
    pieces.push_back({boundary, *at, *std::next(at)});
  }
  return pieces;
}

std::vector<LanePiece> LaneCuts::pieces(const MapLane& lane) const {
  const std::vector<BoundaryPiece> left = side(lane.left_boundary, lane.right_boundary);
  const std::vector<BoundaryPiece> right = side(lane.right_boundary, lane.left_boundary);
  if (left.empty() || left.size() != right.size()) {
    throw input_error(fmt::format("{}, lane {}", place_, lane.id),
                      fmt::format("cannot be cut into short lanes: its boundaries have {} and {} pieces",
                                  left.size(), right.size()),
                      "write GeoJSON instead");
  }
  std::vector<LanePiece> pieces;
  for (std::size_t i = 0; i < left.size(); ++i) pieces.push_back({left[i], right[i]});
  return pieces;
}

}  // namespace lanefuse
