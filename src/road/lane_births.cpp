// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/lane_births.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kReach = 90;      ///< [m] vehicles further away found no lane
constexpr double kFarAside = 13;   ///< [m] to either side
constexpr double kSame = 1.2;      ///< [m] between vehicles of one lane
constexpr double kSightings = 15;  ///< of late
constexpr double kMemory = 6;      ///< [s]
constexpr double kCertain = 0.9;   ///< [m] sigma of the road's course there, at most
constexpr double kAnEdge = 1.2;  ///< [m] from where a lane's edge must be: a line that is known is that edge
constexpr double kApart = 2.0;   ///< [m] between lines
constexpr double kOffMiddle = 0.4;  ///< [m] sigma of a first lane's place
constexpr std::size_t kMost = 16;

const KnownLine* line_near(const RoadState& state, double lateral) {
  const KnownLine* nearest = nullptr;
  double least = kAnEdge;
  for (const KnownLine& line : state.lines()) {
    const double away = std::abs(state.offset(line, 20) - lateral);
    if (away >= least) continue;
    nearest = &line;
    least = away;
  }
  return nearest;
}

bool is_apart(const RoadState& state, double lateral) {
  return std::all_of(state.lines().begin(), state.lines().end(), [&](const KnownLine& line) {
    return std::abs(state.offset(line, 20) - lateral) > kApart;
  });
}

}  // namespace

void LaneBirths::move(double aside, double seconds) {
  for (Candidate& candidate : candidates_) {
    candidate.lateral -= aside;
    candidate.weight *= std::exp(-seconds / kMemory);
  }
  std::erase_if(candidates_, [](const Candidate& candidate) { return candidate.weight < 0.5; });
}

void LaneBirths::gather(std::span<const VehicleUpdate::Sighting> strays, const RoadState& state) {
  for (const VehicleUpdate::Sighting& stray : strays) {
    const RoadAxis::Foot foot = state.axis().project(stray.middle);
    if (foot.place.station > kReach || std::abs(foot.lateral) > kFarAside) continue;
    SparseRow row;
    state.add_lateral(row, foot.place);
    if (state.numbers().variance(row) > kCertain * kCertain) continue;
    auto same = std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
      return std::abs(candidate.lateral - foot.lateral) < kSame;
    });
    if (same == candidates_.end()) {
      if (candidates_.size() == kMost) continue;
      candidates_.push_back({foot.lateral, 0});
      same = candidates_.end() - 1;
    }
    same->weight += 1;
    same->lateral += (foot.lateral - same->lateral) / same->weight;
  }
}

void LaneBirths::found_lanes(const LaneWidth& width, RoadState& state) {
  for (auto candidate = candidates_.begin(); candidate != candidates_.end();) {
    if (candidate->weight < kSightings) {
      ++candidate;
      continue;
    }
    found_lane(candidate->lateral, width, state);
    candidate = candidates_.erase(candidate);
  }
}

void LaneBirths::found_lane(double middle, const LaneWidth& width, RoadState& state) {
  const KnownLine* left = line_near(state, middle + width.mean / 2);
  const KnownLine* right = line_near(state, middle - width.mean / 2);
  if (left && right) return;
  if (left) {
    const double place = state.offset(*left, 20) - width.mean;
    if (is_apart(state, place)) state.add_line_beside(left->id, -width.mean, width.standard_deviation);
  } else if (right) {
    const double place = state.offset(*right, 20) + width.mean;
    if (is_apart(state, place)) state.add_line_beside(right->id, width.mean, width.standard_deviation);
  } else if (is_apart(state, middle + width.mean / 2) && is_apart(state, middle - width.mean / 2)) {
    const KnownLine* line = state.add_line(middle + width.mean / 2, kOffMiddle);
    if (!line) return;
    state.add_line_beside(line->id, -width.mean, width.standard_deviation);
  }
}

}  // namespace lanefuse
