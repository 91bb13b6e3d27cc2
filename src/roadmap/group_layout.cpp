// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/group_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "core/error.hpp"
#include "roadmap/opendrive_plan.hpp"

namespace lanefuse {
namespace {

/// Ends of lanes that are this close along the road count as one: bounds seldom end exactly side by side.
constexpr double kSameStation = 2.0;  // [m]

std::vector<const MapBoundary*> boundaries_of(const RoadMap& map, const LaneGroup& lanes) {
  std::set<std::uint64_t> ids;
  for (const MapLane* lane : lanes) ids.insert({lane->left_boundary, lane->right_boundary});
  std::vector<const MapBoundary*> boundaries;
  for (const std::uint64_t id : ids) boundaries.push_back(find_boundary(map, id));
  return boundaries;
}

PlanView make_plan(const RoadMap& map, const LaneGroup& lanes, const ExactPlan* plan,
                   const std::string& place) {
  return plan ? exact_plan_view(*plan) : smooth_plan_view(boundaries_of(map, lanes), place);
}

/// Sorted stations, each cluster of near ones by its mean; the first is the road's begin and the last its
/// end.
std::vector<double> clustered(std::vector<double> stations, double end) {
  std::sort(stations.begin(), stations.end());
  std::vector<double> means;
  for (std::size_t i = 0; i < stations.size();) {
    std::size_t after = i;
    double sum = 0;
    while (after < stations.size() && stations[after] - stations[i] <= kSameStation) sum += stations[after++];
    means.push_back(sum / static_cast<double>(after - i));
    i = after;
  }
  if (means.front() <= kSameStation) means.front() = 0;
  if (means.front() > 0) means.insert(means.begin(), 0);
  if (means.back() >= end - kSameStation) means.back() = end;
  if (means.back() < end) means.push_back(end);
  return means;
}

double nearest(const std::vector<double>& stations, double station) {
  return *std::min_element(stations.begin(), stations.end(), [station](double a, double b) {
    return std::abs(a - station) < std::abs(b - station);
  });
}

/// Which lanes belong together, as a forest over their places in the map.
class Forest {
 public:
  explicit Forest(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t root(std::size_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void join(std::size_t a, std::size_t b) {
    parent_[std::max(root(a), root(b))] = std::min(root(a), root(b));
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<LaneGroup> lane_groups(const RoadMap& map) {
  std::map<std::uint64_t, std::size_t> index;
  for (std::size_t i = 0; i < map.lanes.size(); ++i) index[map.lanes[i].id] = i;
  Forest forest(map.lanes.size());
  std::map<std::uint64_t, std::size_t> by_boundary;
  for (std::size_t i = 0; i < map.lanes.size(); ++i) {
    const MapLane& lane = map.lanes[i];
    for (const std::uint64_t boundary : {lane.left_boundary, lane.right_boundary}) {
      forest.join(i, by_boundary.try_emplace(boundary, i).first->second);
    }
    if (lane.left_lane) forest.join(i, index.at(*lane.left_lane));
    if (lane.right_lane) forest.join(i, index.at(*lane.right_lane));
    for (const std::uint64_t next : lane.successors) forest.join(i, index.at(next));
  }
  std::map<std::size_t, LaneGroup> groups;
  for (std::size_t i = 0; i < map.lanes.size(); ++i) groups[forest.root(i)].push_back(&map.lanes[i]);
  std::vector<LaneGroup> listed;
  for (auto& [root, group] : groups) listed.push_back(std::move(group));
  return listed;
}

GroupLayout::GroupLayout(const RoadMap& map, const LaneGroup& lanes, const ExactPlan* plan,
                         const std::string& place)
    : plan_(make_plan(map, lanes, plan, place)) {
  for (const MapBoundary* boundary : boundaries_of(map, lanes)) {
    offsets_.emplace(boundary->id, BoundaryOffsets(*boundary, plan_, place));
  }
  find_spans(lanes, place);
}

/// A lane runs as far as both of its boundaries do.
void GroupLayout::find_spans(const LaneGroup& lanes, const std::string& place) {
  std::vector<double> ends;
  for (const MapLane* lane : lanes) {
    const BoundaryOffsets& left = offsets(lane->left_boundary);
    const BoundaryOffsets& right = offsets(lane->right_boundary);
    const double begin = std::clamp(std::max(left.begin(), right.begin()), 0.0, plan_.end());
    const double end = std::clamp(std::min(left.end(), right.end()), 0.0, plan_.end());
    spans_.push_back({lane, begin, end});
    ends.insert(ends.end(), {begin, end});
  }
  stations_ = clustered(std::move(ends), plan_.end());
  for (Span& span : spans_) {
    span.begin = nearest(stations_, span.begin);
    span.end = nearest(stations_, span.end);
    if (span.end > span.begin) continue;
    throw input_error(fmt::format("{}, lane {}", place, span.lane->id),
                      "has boundaries that do not run side by side for 2 m along its road");
  }
}

std::vector<const MapLane*> GroupLayout::lanes_between(double from, double to) const {
  const double middle = (from + to) / 2;
  std::vector<const MapLane*> present;
  for (const Span& span : spans_) {
    if (span.begin < middle && middle < span.end) present.push_back(span.lane);
  }
  const auto centre = [&](const MapLane* lane) {
    return offsets(lane->left_boundary).offset(middle) + offsets(lane->right_boundary).offset(middle);
  };
  std::stable_sort(present.begin(), present.end(),
                   [&](const MapLane* a, const MapLane* b) { return centre(a) > centre(b); });
  return present;
}

const BoundaryOffsets& GroupLayout::longest() const {
  const auto found = std::max_element(offsets_.begin(), offsets_.end(), [](const auto& a, const auto& b) {
    return a.second.end() - a.second.begin() < b.second.end() - b.second.begin();
  });
  return found->second;
}

}  // namespace lanefuse
