// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/line_births.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kReach = 100;        ///< [m] paint further away founds no line
constexpr double kFirstReach = 35;    ///< [m] the same while no line is known
constexpr double kFarAside = 14;      ///< [m]
constexpr double kSame = 0.4;         ///< [m] of one candidate
constexpr double kApart = 2.3;        ///< [m] from lines that are known
constexpr double kFrames = 5;         ///< that must have seen it
constexpr double kPerFrame = 2.5;     ///< features of it in a frame, on average
constexpr double kLength = 18;        ///< [m] along which it must have been seen
constexpr double kSeenFromNear = 15;  ///< [m] what is seen from there on has always been there
constexpr double kMemory = 60;        ///< [m] driven, over which it is forgotten
constexpr std::size_t kMost = 32;
constexpr double kForgotten = 400;  ///< [m] driven without a line being seen
constexpr double kGone = 80;        ///< [m] the same for an outermost line, where others are seen
constexpr double kSeen = 4;         ///< features in a frame, of a line that the camera sees
constexpr double kEgoEdge = 3;      ///< [m] a line nearer than this may bound the ego lane
constexpr double kOneLine = 1.2;    ///< [m] two lines nearer than this all along are one

}  // namespace

void LineBirths::move(double aside, double along) {
  for (Candidate& candidate : candidates_) {
    candidate.lateral -= aside;
    candidate.begin -= along;
    candidate.end -= along;
    const double keep = std::exp(-along / kMemory);
    candidate.weight *= keep;
    candidate.frames *= keep;
  }
  std::erase_if(candidates_, [](const Candidate& c) { return c.weight < 0.5; });
}

void LineBirths::gather(std::span<const StrayPaint> strays, const RoadState& state) {
  for (Candidate& candidate : candidates_) candidate.in_frame = false;
  const bool labelled = config_.association == RoadAssociation::labelled;
  const double reach = state.lines().empty() ? kFirstReach : kReach;
  for (const StrayPaint& stray : strays) {
    if (stray.station > reach || std::abs(stray.lateral) > kFarAside || stray.label == kNoLine) continue;
    auto nearest = candidates_.end();
    double least = kSame;
    for (auto c = candidates_.begin(); c != candidates_.end(); ++c) {
      const double away = std::abs(c->lateral - stray.lateral);
      if (labelled && c->label != stray.label) continue;
      if (away < least) {
        nearest = c;
        least = away;
      }
    }
    if (nearest == candidates_.end()) {
      if (candidates_.size() == kMost) continue;
      candidates_.push_back({stray.lateral, 0, 0, stray.station, stray.station, stray.label});
      nearest = candidates_.end() - 1;
    }
    nearest->lateral += (stray.lateral - nearest->lateral) / (std::min(nearest->weight, 20.0) + 1);
    nearest->weight += 1;
    nearest->begin = std::min(nearest->begin, stray.station);
    nearest->end = std::max(nearest->end, stray.station);
    if (!nearest->in_frame) nearest->frames += 1;
    nearest->in_frame = true;
  }
}

bool LineBirths::is_line(const Candidate& candidate, const RoadState& state) const {
  if (config_.association == RoadAssociation::labelled) {
    return candidate.label >= 0 && candidate.frames >= 2;
  }
  if (candidate.frames < kFrames || candidate.weight < kPerFrame * candidate.frames) return false;
  if (candidate.end - candidate.begin < kLength) return false;
  const double middle = std::max(0.0, (candidate.begin + candidate.end) / 2);
  return std::all_of(state.lines().begin(), state.lines().end(), [&](const KnownLine& line) {
    return std::abs(state.offset(line, middle) - candidate.lateral) > kApart;
  });
}

void LineBirths::found_lines(RoadState& state) {
  for (auto c = candidates_.begin(); c != candidates_.end();) {
    if (!is_line(*c, state)) {
      ++c;
      continue;
    }
    if (KnownLine* line = state.add_line(c->lateral, 0.3)) {
      line->label = c->label;
      if (c->begin > kSeenFromNear) line->begin = c->begin;
    }
    c = candidates_.erase(c);
  }
}

/// Whether it bounds neither the car's own lane nor one further out: nothing but its own paint and vehicles
/// beside it say that it is still there.
bool LineBirths::is_outermost(const KnownLine& line, const RoadState& state) {
  const double beside = state.offset(line, 0);
  return std::none_of(state.lines().begin(), state.lines().end(), [&](const KnownLine& other) {
    const double further = state.offset(other, 0) - beside;
    return beside > 0 ? further > 0.1 || beside < kEgoEdge : further < -0.1 || beside > -kEgoEdge;
  });
}

void LineBirths::forget_lines(RoadState& state) const {
  const bool camera_sees = std::any_of(state.lines().begin(), state.lines().end(),
                                       [](const KnownLine& line) { return line.density > kSeen; });
  for (std::size_t i = state.lines().size(); i-- > 0;) {
    const KnownLine& line = state.lines()[i];
    const double unseen = state.driven() - line.seen_at;
    const bool gone = camera_sees && unseen > kGone && is_outermost(line, state);
    const bool lost = unseen > kForgotten || std::abs(state.offset(line, 0)) > kFarAside + 2;
    const auto same_as = [&](const KnownLine& older) {
      if (older.id >= line.id) return false;
      return std::abs(state.offset(older, 0) - state.offset(line, 0)) < kOneLine &&
             std::abs(state.offset(older, 60) - state.offset(line, 60)) < kOneLine;
    };
    if (gone || lost || std::any_of(state.lines().begin(), state.lines().end(), same_as)) {
      state.remove_line(i);
    }
  }
}

}  // namespace lanefuse
