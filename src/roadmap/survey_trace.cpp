// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_trace.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

/// [m] ahead of the origin, where the markings are read: near, so that pitch and curvature hardly matter.
constexpr std::array kDistances{2.0, 5.0, 8.0};
constexpr double kJump = 1;              ///< [m] from frame to frame: another line
constexpr double kHole = 60;             ///< [m] after which a line need not be the same
constexpr double kSightVariance = 4e-4;  ///< [m^2] of a sight, beyond what the camera believes

/// Gathers one side's sights into traces.
class TraceGatherer {
 public:
  TraceGatherer(const TraceInput& input, Side side, std::vector<SurveyTrace>& traces)
      : input_(input), side_(side), traces_(traces) {}

  void add(const SeenMarking& marking, const Pose2& map_from_vehicle, std::size_t& hint) {
    if (!follows_on(marking, map_from_vehicle, hint)) finish();
    for (const double x : kDistances) {
      const auto place = locate(marking, map_from_vehicle, x, hint);
      if (place) add(*place, marking);
    }
    width_ = marking.paint_width;
  }

  void finish() {
    if (weights_.empty()) return;
    SurveyTrace trace{input_.index, side_, width_, StationSeries(weights_.size(), kUnknown),
                      std::move(votes_)};
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      if (weights_[i] > 0) trace.lateral[i] = sums_[i] / weights_[i];
    }
    traces_.push_back(std::move(trace));
    weights_.clear();
    sums_.clear();
    votes_.clear();
  }

 private:
  const TraceInput& input_;
  Side side_;
  std::vector<SurveyTrace>& traces_;
  std::vector<double> weights_;
  std::vector<double> sums_;
  std::vector<MarkingVotes> votes_;
  SurveyAxis::Place last_;
  double width_ = 0;

  [[nodiscard]] std::optional<SurveyAxis::Place> locate(const SeenMarking& marking,
                                                        const Pose2& map_from_vehicle, double x,
                                                        std::size_t& hint) const {
    const double yaw = input_.yaw.empty() ? 0 : input_.yaw[hint];
    const Eigen::Vector2d point(x, marking.line.y(x) - (is_known(yaw) ? yaw : 0) * x);
    return input_.axis.locate(map_from_vehicle * point, hint);
  }

  bool follows_on(const SeenMarking& marking, const Pose2& map_from_vehicle, std::size_t& hint) {
    const auto place = locate(marking, map_from_vehicle, kDistances.front(), hint);
    if (!place) return true;  // beside the axis there is nothing to follow
    const bool same = weights_.empty() || (std::abs(place->lateral - last_.lateral) < kJump &&
                                           std::abs(place->station - last_.station) < kHole &&
                                           (marking.paint_width > 0) == (width_ > 0));
    last_ = *place;
    return same;
  }

  void add(const SurveyAxis::Place& place, const SeenMarking& marking) {
    const auto station =
        static_cast<std::size_t>(std::max(0.0, std::round(place.station / input_.axis.step())));
    if (station >= input_.axis.knot_count()) return;
    if (weights_.empty()) {
      weights_.assign(input_.axis.knot_count(), 0);
      sums_.assign(input_.axis.knot_count(), 0);
      votes_.assign(input_.axis.knot_count(), {});
    }
    const double weight = 1 / (marking.variance + kSightVariance);
    weights_[station] += weight;
    sums_[station] += weight * place.lateral;
    votes_[station].add(marking.marking);
  }
};

template <std::size_t N>
std::size_t most(const std::array<std::uint32_t, N>& counts) {
  return static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

std::size_t known_stations(const SurveyTrace& trace) {
  return static_cast<std::size_t>(std::count_if(trace.lateral.begin(), trace.lateral.end(), is_known));
}

}  // namespace

void MarkingVotes::add(const MarkingEvidence& marking) {
  ++types[static_cast<std::size_t>(marking.type)];
  ++colours[static_cast<std::size_t>(marking.colour)];
}

MarkingVotes& MarkingVotes::operator+=(const MarkingVotes& other) {
  for (std::size_t i = 0; i < types.size(); ++i) types[i] += other.types[i];
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] += other.colours[i];
  return *this;
}

MarkingEvidence MarkingVotes::winner() const {
  return {static_cast<MarkingType>(most(types)), static_cast<MarkingColour>(most(colours))};
}

std::vector<SurveyTrace> traces_of(const TraceInput& input, std::size_t shortest) {
  std::vector<SurveyTrace> traces;
  TraceGatherer left(input, Side::left, traces);
  TraceGatherer right(input, Side::right, traces);
  std::optional<std::size_t> hint;
  for (const SeenMarking& marking : input.drive.markings) {
    const auto map_from_vehicle = pose_at(input.drive.track, marking.time);
    if (!map_from_vehicle) continue;
    if (!hint) hint = input.axis.nearest_knot(map_from_vehicle->position());
    (marking.side == Side::left ? left : right).add(marking, *map_from_vehicle, *hint);
  }
  left.finish();
  right.finish();
  std::erase_if(traces, [shortest](const SurveyTrace& trace) { return known_stations(trace) < shortest; });
  return traces;
}

}  // namespace lanefuse
