// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/vehicle_update.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kWidestLane = 5.5;  ///< [m]
constexpr double kNarrowestLane = 2.2;
constexpr double kForgotten = 3;     ///< [s] unseen
constexpr double kUncertain = 0.5;   ///< [m] sigma of the lane's middle, above which lanes may be mixed up
constexpr double kAway = 1.0;        ///< [m] from the middle: on the way to another lane
constexpr double kSurprising = 2.5;  ///< mean squared surprise of a vehicle that changes lane

double square(double x) { return x * x; }

/// The lines next to a place on both sides, as indices; false where one is missing or the gap is no lane.
bool lane_at(const RoadState& state, double station, double lateral, std::size_t& left, std::size_t& right) {
  double nearest_left = kWidestLane;
  double nearest_right = kWidestLane;
  for (std::size_t i = 0; i < state.lines().size(); ++i) {
    const double away = state.offset(state.lines()[i], station) - lateral;
    if (away > 0 && away < nearest_left) {
      nearest_left = away;
      left = i;
    }
    if (away <= 0 && -away < nearest_right) {
      nearest_right = -away;
      right = i;
    }
  }
  const double width = nearest_left + nearest_right;
  return nearest_left < kWidestLane && nearest_right < kWidestLane && width < kWidestLane &&
         width > kNarrowestLane;
}

/// Whether the road's course is known well enough there to say which lane a place is in.
bool is_certain(const RoadState& state, const RoadAxis::Foot& foot, const RoadLine& left,
                const RoadLine& right) {
  SparseRow row;
  const double station = foot.place.station;
  state.add_lateral(row, foot.place);
  state.add_offset(row, left, station, -0.5);
  state.add_offset(row, right, station, -0.5);
  return state.numbers().variance(row) < square(kUncertain);
}

}  // namespace

void VehicleUpdate::gather(const FeatureSet& set, const Pose2& now_from_measured) {
  sightings_.clear();
  const double half_width = set.lane_width.value_or(LaneWidth{}).mean / 2;
  for (const Feature& feature : set.features) {
    if (feature.track_id == kNoTrack || feature.side == Side::none) continue;
    const double sign = feature.side == Side::left ? -1 : 1;
    const Eigen::Vector2d across(-std::sin(feature.heading), std::cos(feature.heading));
    const Eigen::Vector2d middle = Eigen::Vector2d(feature.x, feature.y) + sign * half_width * across;
    auto one = std::find_if(sightings_.begin(), sightings_.end(),
                            [&](const Sighting& s) { return s.track_id == feature.track_id; });
    if (one == sightings_.end()) {
      sightings_.push_back({feature.track_id, now_from_measured * middle, middle.norm(),
                            across.dot(feature.covariance.topLeftCorner<2, 2>() * across),
                            feature.changing_lane});
      one = sightings_.end() - 1;
    }
    (feature.side == Side::left ? one->left : one->right) = feature.label;
  }
}

std::size_t VehicleUpdate::take(const FeatureSet& set, const Pose2& now_from_measured, RoadState& state) {
  gather(set, now_from_measured);
  strays_.clear();
  for (std::size_t i = state.vehicles().size(); i-- > 0;) {
    if (to_seconds(set.measured_at - state.vehicles()[i].seen) > kForgotten) state.remove_vehicle(i);
  }
  // From near to far: what the near ones tell of the road's course says in which lanes the far ones are.
  std::sort(sightings_.begin(), sightings_.end(), [](const Sighting& a, const Sighting& b) {
    return a.range < b.range || (a.range == b.range && a.track_id < b.track_id);
  });
  std::size_t used = 0;
  for (const Sighting& sighting : sightings_) {
    if (take_one(sighting, set.measured_at, state)) ++used;
  }
  return used;
}

bool VehicleUpdate::take_one(const Sighting& sighting, Time now, RoadState& state) {
  state.rebuild_axis();
  const RoadAxis::Foot foot = state.axis().project(sighting.middle);
  const double station = foot.place.station;
  auto& vehicles = state.vehicles();
  auto known = std::find_if(vehicles.begin(), vehicles.end(), [&](const RoadVehicle& vehicle) {
    return vehicle.track_id == sighting.track_id;
  });
  if (sighting.changing_lane || sighting.left == kNoLine || sighting.right == kNoLine) {
    if (known != vehicles.end()) state.remove_vehicle(static_cast<std::size_t>(known - vehicles.begin()));
    return true;
  }
  const bool labelled = config_.association == RoadAssociation::labelled;
  std::size_t left = 0;
  std::size_t right = 0;
  if (labelled && sighting.left >= 0) {
    const auto find = [&](LineLabel label) {
      const auto& lines = state.lines();
      return static_cast<std::size_t>(
          std::find_if(lines.begin(), lines.end(), [label](const RoadLine& l) { return l.label == label; }) -
          lines.begin());
    };
    left = find(sighting.left);
    right = find(sighting.right);
    if (left == state.lines().size() || right == state.lines().size()) return false;
  } else if (!lane_at(state, station, foot.lateral, left, right)) {
    strays_.push_back(sighting);
    return false;
  }
  const RoadLine& left_line = state.lines()[left];
  const RoadLine& right_line = state.lines()[right];
  const double middle = (state.offset(left_line, station) + state.offset(right_line, station)) / 2;
  const bool is_known = known != vehicles.end();
  if (!labelled && !is_known && !is_certain(state, foot, left_line, right_line)) return false;
  if (known == vehicles.end() || known->left != left_line.id || known->right != right_line.id) {
    if (known != vehicles.end()) state.remove_vehicle(static_cast<std::size_t>(known - vehicles.begin()));
    RoadVehicle* vehicle = state.add_vehicle(sighting.track_id);
    if (!vehicle) return false;
    vehicle->left = left_line.id;
    vehicle->right = right_line.id;
    vehicle->seen = now - from_seconds(config_.vehicles.sensor.tau);
    known = vehicles.end() - 1;
  }
  SparseRow row;
  state.add_lateral(row, foot.place);
  state.add_offset(row, left_line, station, -0.5);
  state.add_offset(row, right_line, station, -0.5);
  row.add(known->index, -1);
  row.add(kVehicleYaw, -sighting.range);
  const double residual = foot.lateral - middle - state.numbers().mean(known->index) -
                          sighting.range * state.numbers().mean(kVehicleYaw);
  // Looks that follow each other within the time for which a track errs the same way say little new.
  const double seconds = std::max(0.01, to_seconds(now - known->seen));
  const double repeats = std::max(1.0, 2 * config_.vehicles.sensor.tau / seconds);
  const double own = std::max(sighting.variance - square(config_.vehicles.driver.sigma),
                              square(config_.vehicles.sensor.sigma) / 4);
  const double expected = state.numbers().variance(row) + own;
  const double fresh = std::min(1.0, seconds / config_.vehicles.sensor.tau);
  known->surprise += fresh * (square(residual) / expected - known->surprise);
  known->seen = now;
  if (known->surprise > kSurprising || std::abs(foot.lateral - middle) > kAway + std::sqrt(expected)) {
    return true;
  }
  state.numbers().update(row, -residual, own * repeats * square(std::max(1.0, known->surprise)));
  auto& lines = state.lines();
  ++lines[left].witnessed;
  ++lines[right].witnessed;
  lines[left].traffic_on_right += 1;
  lines[right].traffic_on_left += 1;
  return true;
}

}  // namespace lanefuse
