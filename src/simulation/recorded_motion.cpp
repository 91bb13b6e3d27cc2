// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/recorded_motion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kTimeSpacing = 0.6;  ///< [s] between knots: nobody brakes and accelerates faster
constexpr double kPathSpacing = 12;   ///< [m] between knots: half of what a lane change takes in a jam
constexpr double kTangent = 6;        ///< [m] of the recorded heading, before the path and behind it

/// Along the recorded headings, so that a car that stands does not count its noise as a way.
std::vector<double> ways_of(const std::vector<RecordedState>& states) {
  std::vector<double> ways{0};
  for (std::size_t i = 1; i < states.size(); ++i) {
    const RecordedState& from = states[i - 1];
    const RecordedState& to = states[i];
    const double heading = from.heading + wrap_angle(to.heading - from.heading) / 2;
    const double step = (to.x - from.x) * std::cos(heading) + (to.y - from.y) * std::sin(heading);
    ways.push_back(ways.back() + step);
  }
  return ways;
}

SmoothCurve way_by_time(const std::vector<RecordedState>& states, const std::vector<double>& ways) {
  std::vector<SmoothCurve::Sample> samples;
  for (std::size_t i = 0; i < states.size(); ++i) samples.push_back({states[i].time_s, ways[i]});
  SmoothCurve curve(samples, kTimeSpacing);
  curve.make_rising();
  return curve;
}

}  // namespace

Pose2 RecordedMotion::Path::pose(double way) const {
  const SmoothCurve::Place px = x.at(way);
  const SmoothCurve::Place py = y.at(way);
  return {px.value, py.value, std::atan2(py.slope, px.slope)};
}

RecordedMotion::RecordedMotion(const RecordedVehicle& vehicle, double ahead)
    : begin_(vehicle.states.front().time_s),
      end_(vehicle.states.back().time_s),
      ways_(ways_of(vehicle.states)),
      way_(way_by_time(vehicle.states, ways_)),
      path_(lay(vehicle.states, ways_)) {
  if (ahead != 0) path_ = beside(path_, ways_, ahead);
}

/// The recorded headings at both ends keep the path straight where the vehicle hardly moves.
RecordedMotion::Path RecordedMotion::lay(const std::vector<RecordedState>& states,
                                         const std::vector<double>& ways) {
  std::vector<SmoothCurve::Sample> x, y;
  const auto add = [&](const RecordedState& state, double way, double off) {
    x.push_back({way + off, state.x + off * std::cos(state.heading)});
    y.push_back({way + off, state.y + off * std::sin(state.heading)});
  };
  for (std::size_t i = 0; i < states.size(); ++i) add(states[i], ways[i], 0);
  const auto [least, most] = std::ranges::minmax_element(ways);
  add(states[static_cast<std::size_t>(least - ways.begin())], *least, -kTangent);
  add(states[static_cast<std::size_t>(most - ways.begin())], *most, kTangent);
  return {SmoothCurve(x, kPathSpacing), SmoothCurve(y, kPathSpacing)};
}

/// Of a point ahead of the middle: where the first path says it is, smooth once more.
RecordedMotion::Path RecordedMotion::beside(const Path& middle, const std::vector<double>& ways,
                                            double ahead) {
  std::vector<SmoothCurve::Sample> x, y;
  const auto [least, most] = std::ranges::minmax(ways);
  for (double way = least - kTangent; way <= most + kTangent; way += 1) {
    const Pose2 point = middle.pose(way) * Pose2{ahead, 0, 0};
    x.push_back({way, point.x});
    y.push_back({way, point.y});
  }
  return {SmoothCurve(x, kPathSpacing), SmoothCurve(y, kPathSpacing)};
}

RecordedMotion::State RecordedMotion::at(double time) const {
  const SmoothCurve::Place way = way_.at(time);
  const SmoothCurve::Place x = path_.x.at(way.value);
  const SmoothCurve::Place y = path_.y.at(way.value);
  const double stretch = std::hypot(x.slope, y.slope);  // metres of path a metre of way: almost 1
  const double turn = (x.slope * y.bend - y.slope * x.bend) / (stretch * stretch);  // rad a metre of way
  const double pace = std::max(0.0, way.slope);
  return {{x.value, y.value, std::atan2(y.slope, x.slope)}, way.value, stretch * pace, turn * pace};
}

}  // namespace lanefuse
