// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/traffic_lanes.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kLeastWidth = 2.6;  ///< [m] of a lane that begins or ends, to be driven in
constexpr double kSlack = 1;         ///< [m] to the road's end: a lane that reaches it goes on

}  // namespace

TrafficLanes::TrafficLanes(const Road& road) : road_(road) {
  for (int lane = 0; lane < road.lane_count(); ++lane) stretches_.push_back(usable_stretch(lane));
}

TrafficLanes::Stretch TrafficLanes::usable_stretch(int lane) const {
  double begin = road_.lane_begin(lane);
  double end = road_.lane_end(lane);
  const auto narrow = [&](double station) { return road_.lane_width(lane, station) < kLeastWidth; };
  const bool begins = begin > kSlack;
  const bool ends = end < road_.reference().length() - kSlack;
  while (begins && begin < end && narrow(begin)) ++begin;
  while (ends && end > begin && narrow(end)) --end;
  return {begins ? begin : -INFINITY, ends ? end : INFINITY};
}

bool TrafficLanes::is_open(int lane, double station) const {
  return kind(lane) != LaneKind::emergency && station >= begin(lane) && station <= end(lane);
}

bool TrafficLanes::is_through(int lane, double station) const {
  return is_driving(lane) && is_open(lane, station) && station + kNotice < end(lane);
}

std::optional<int> TrafficLanes::beside(int lane, int side, double station) const {
  const std::optional<int> neighbour = road_.neighbour(lane, side > 0 ? Side::left : Side::right, station);
  return neighbour && is_open(*neighbour, station) ? neighbour : std::nullopt;
}

std::optional<int> TrafficLanes::through_beside(int lane, int side, double station) const {
  const std::optional<int> neighbour = beside(lane, side, station);
  return neighbour && is_through(*neighbour, station) ? neighbour : std::nullopt;
}

int TrafficLanes::through_count(double station) const {
  int through = 0;
  for (int lane = 0; lane < count(); ++lane) through += is_through(lane, station);
  return through;
}

int TrafficLanes::middle(double station) const {
  int left = through_count(station) / 2;
  for (int lane = 0; lane < count(); ++lane) {
    if (is_through(lane, station) && left-- == 0) return lane;
  }
  return 0;
}

int TrafficLanes::count_right_of(int lane, double station) const {
  int lanes = 0;
  for (int right = lane + 1; right < count(); ++right) lanes += is_through(right, station);
  return lanes;
}

double TrafficLanes::within(int lane, double station) const {
  return std::clamp(station, road_.lane_begin(lane), road_.lane_end(lane));
}

LateralMotion::State TrafficLanes::centre(int lane, const Progress& vehicle) const {
  const double station = within(lane, vehicle.station);
  const double position = road_.lane_centre(lane, station);
  if (station != vehicle.station) return {position, 0, 0};
  const auto slope = [&](double there) { return road_.lane_centre_slope(lane, within(lane, there)); };
  const double bend = slope(station + 0.5) - slope(station - 0.5);  // a metre
  return {position, slope(station) * vehicle.speed,
          bend * vehicle.speed * vehicle.speed + slope(station) * vehicle.acceleration};
}

/// Without the rounding in which the lanes of a road of one width differ.
double TrafficLanes::width_of(int lane, double station) const {
  const double width = road_.lane_width(lane, station);
  const double usual = road_.lane_width();
  return std::abs(width - usual) < 1e-9 ? usual : width;
}

double TrafficLanes::room(int lane, double station, double ahead, double width) const {
  double narrowest = INFINITY;
  for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double place = within(lane, station + fraction * ahead);
    if (is_open(lane, place)) narrowest = std::min(narrowest, width_of(lane, place));
  }
  return std::max(0.0, (narrowest - width) / 2 - 0.02);
}

}  // namespace lanefuse
