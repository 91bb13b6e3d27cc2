// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/lane_strips.hpp"

#include <algorithm>
#include <map>

#include "roadmap/edge_chains.hpp"

namespace lanefuse {
namespace {

constexpr double kRepeated = 0.01;  // [m]

/// Strips that make one lane, in driving direction.
using Run = std::vector<std::size_t>;

/// The strip that continues this one between the same two boundaries.
std::optional<std::size_t> continuation(const std::vector<LaneStrip>& strips, const EdgeChains& chains,
                                        std::size_t strip) {
  const auto next_left = chains.next(chains.edge_of(strip, StripSide::left));
  const auto next_right = chains.next(chains.edge_of(strip, StripSide::right));
  if (!next_left || !next_right) return std::nullopt;
  for (const std::size_t other : strips[strip].successors) {
    if (strips[other].kind == strips[strip].kind && chains.edge_of(other, StripSide::left) == *next_left &&
        chains.edge_of(other, StripSide::right) == *next_right) {
      return other;
    }
  }
  return std::nullopt;
}

std::vector<Run> runs_of(const std::vector<LaneStrip>& strips, const EdgeChains& chains) {
  std::vector<std::optional<std::size_t>> next(strips.size());
  std::vector<bool> continues_another(strips.size(), false);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const std::optional<std::size_t> after = continuation(strips, chains, i);
    if (!after || continues_another[*after]) continue;
    next[i] = after;
    continues_another[*after] = true;
  }
  std::vector<Run> runs;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (continues_another[i]) continue;  // chains of edges are no rings, so neither are runs
    Run& run = runs.emplace_back();
    for (std::optional<std::size_t> at = i; at; at = next[*at]) run.push_back(*at);
  }
  return runs;
}

/// Of two edges the one to cut: that which fewer lanes share.
std::size_t lesser(const EdgeChains& chains, std::size_t left, std::size_t right) {
  return chains.users(left) < chains.users(right) ? left : right;
}

/// A lane runs as far as both of its boundaries do, so at each of its ends one of them must end.
bool cut_at_ends(EdgeChains& chains, const Run& run) {
  bool has_cut = false;
  const auto at = [&chains](std::size_t strip, StripSide side) { return chains.edge_of(strip, side); };
  const auto before_left = chains.previous(at(run.front(), StripSide::left));
  const auto before_right = chains.previous(at(run.front(), StripSide::right));
  if (before_left && before_right) {
    chains.cut_after(lesser(chains, *before_left, *before_right));
    has_cut = true;
  }
  const std::size_t left = at(run.back(), StripSide::left);
  const std::size_t right = at(run.back(), StripSide::right);
  if (chains.next(left) && chains.next(right)) {
    chains.cut_after(lesser(chains, left, right));
    has_cut = true;
  }
  return has_cut;
}

/// The runs, once each one's ends are told by the ends of its boundaries.
std::vector<Run> settled_runs(const std::vector<LaneStrip>& strips, EdgeChains& chains) {
  for (;;) {  // every round cuts a link, of which there are finitely many
    std::vector<Run> runs = runs_of(strips, chains);
    bool has_cut = false;
    for (const Run& run : runs) has_cut = cut_at_ends(chains, run) || has_cut;
    if (!has_cut) return runs;
  }
}

void append_styles(const StripEdge& edge, double from, MapBoundary& boundary) {
  for (MarkingStyle style : edge.styles) {
    style.from += from;
    if (!boundary.styles.empty() && boundary.styles.back().marking == style.marking &&
        boundary.styles.back().width == style.width) {
      continue;
    }
    while (!boundary.styles.empty() && boundary.styles.back().from >= style.from) boundary.styles.pop_back();
    if (boundary.styles.empty()) style.from = 0;
    boundary.styles.push_back(style);
  }
}

MapBoundary boundary_of_chain(const EdgeChains& chains, std::size_t first, std::uint64_t id) {
  MapBoundary boundary{id, {}, {}};
  double length = 0;
  for (std::optional<std::size_t> at = first; at; at = chains.next(*at)) {
    const StripEdge& edge = chains.shape(*at);
    append_styles(edge, length, boundary);
    length += arc_length(edge.points);
    boundary.points.insert(boundary.points.end(), edge.points.begin(), edge.points.end());
  }
  boundary.points = without_repeats(boundary.points);
  return boundary;
}

/// Makes the map from runs and chains.
class Assembly {
 public:
  Assembly(const std::vector<LaneStrip>& strips, const EdgeChains& chains, std::vector<Run> runs)
      : strips_(strips), chains_(chains), runs_(std::move(runs)), run_of_(strips.size()) {
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      for (const std::size_t strip : runs_[run]) run_of_[strip] = run;
    }
  }

  RoadMap map() {
    std::vector<MapLane> lanes;
    for (const Run& run : runs_) lanes.push_back(lane(run));
    RoadMap map;
    for (const std::size_t i : from_left_to_right(lanes)) {
      lanes[i].left_boundary = boundary(runs_[i].front(), StripSide::left, map);
      lanes[i].right_boundary = boundary(runs_[i].front(), StripSide::right, map);
      map.lanes.push_back(std::move(lanes[i]));
    }
    return map;
  }

 private:
  [[nodiscard]] std::uint64_t id_of(std::size_t run) const { return strips_[runs_[run].front()].id; }

  [[nodiscard]] MapLane lane(const Run& run) const {
    MapLane lane{strips_[run.front()].id, strips_[run.front()].kind, 0, 0, {}, {}, {}};
    lane.left_lane = longest_neighbour(run, &LaneStrip::left_strip);
    lane.right_lane = longest_neighbour(run, &LaneStrip::right_strip);
    for (const std::size_t strip : strips_[run.back()].successors) {
      const std::uint64_t id = id_of(run_of_[strip]);
      if (std::find(lane.successors.begin(), lane.successors.end(), id) == lane.successors.end()) {
        lane.successors.push_back(id);
      }
    }
    return lane;
  }

  /// Beside a long lane several may follow one another.
  [[nodiscard]] std::optional<std::uint64_t> longest_neighbour(
      const Run& run, std::optional<std::size_t> LaneStrip::*beside) const {
    std::map<std::size_t, double> lengths;
    for (const std::size_t strip : run) {
      const std::optional<std::size_t> other = strips_[strip].*beside;
      if (other) lengths[run_of_[*other]] += arc_length(strips_[strip].edge(StripSide::left).points);
    }
    const auto longest = std::max_element(lengths.begin(), lengths.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    return longest == lengths.end() ? std::nullopt : std::optional(id_of(longest->first));
  }

  [[nodiscard]] std::vector<std::size_t> from_left_to_right(const std::vector<MapLane>& lanes) const {
    std::map<std::uint64_t, std::size_t> index;
    for (std::size_t i = 0; i < lanes.size(); ++i) index[lanes[i].id] = i;
    std::vector<std::size_t> order;
    std::vector<bool> taken(lanes.size(), false);
    const auto take_from = [&](std::size_t at) {
      while (!taken[at]) {
        taken[at] = true;
        order.push_back(at);
        if (!lanes[at].right_lane) return;
        at = index.at(*lanes[at].right_lane);
      }
    };
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      if (!lanes[i].left_lane) take_from(i);
    }
    for (std::size_t i = 0; i < lanes.size(); ++i) take_from(i);
    return order;
  }

  /// The id of the boundary, which is put into the map when it is first asked for.
  std::uint64_t boundary(std::size_t strip, StripSide side, RoadMap& map) {
    const std::size_t first = chains_.first_of_chain(chains_.edge_of(strip, side));
    const auto [found, is_new] = boundary_ids_.try_emplace(first, boundary_ids_.size() + 1);
    if (is_new) map.boundaries.push_back(boundary_of_chain(chains_, first, found->second));
    return found->second;
  }

  const std::vector<LaneStrip>& strips_;
  const EdgeChains& chains_;
  std::vector<Run> runs_;
  std::vector<std::size_t> run_of_;
  std::map<std::size_t, std::uint64_t> boundary_ids_;
};

}  // namespace

double arc_length(const std::vector<Eigen::Vector3d>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

std::vector<Eigen::Vector3d> without_repeats(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> kept;
  kept.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    if (kept.empty() || (point - kept.back()).head<2>().norm() >= kRepeated) kept.push_back(point);
  }
  if (kept.size() > 1 && kept.back() != points.back()) kept.back() = points.back();
  return kept;
}

RoadMap join_strips(const std::vector<LaneStrip>& strips) {
  EdgeChains chains(strips);
  std::vector<Run> runs = settled_runs(strips, chains);
  return Assembly(strips, chains, std::move(runs)).map();
}

}  // namespace lanefuse
