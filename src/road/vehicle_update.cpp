// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/vehicle_update.hpp"

#include <algorithm>
#include <cmath>

#include "road/heading_update.hpp"

namespace lanefuse {
namespace {

constexpr double kWidestLane = 5.5;  ///< [m]
constexpr double kNarrowestLane = 2.2;
constexpr double kForgotten = 3;      ///< [s] unseen
constexpr double kUncertain = 0.5;    ///< [m] sigma of the lane's middle, above which lanes may be mixed up
constexpr double kFarthestLine = 9;   ///< [m] from a vehicle whose lane is not known
constexpr double kStrangerSigma = 2;  ///< [m] of how far such a vehicle is from that line
constexpr double kHeadingTau = 2;     ///< [s] for which a driver's heading errs the same way
constexpr double kOwnHeading = 0.02;  ///< [rad] sigma of the car's own
constexpr double kAway = 1.0;         ///< [m] from the middle: on the way to another lane
constexpr double kSurprising = 2.5;   ///< mean squared surprise of a vehicle that changes lane

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
bool is_certain(const RoadState& state, const RoadAxis::Foot& foot, const KnownLine& left,
                const KnownLine& right) {
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
                            now_from_measured.heading + feature.heading, feature.covariance(2, 2),
                            feature.changing_lane});
      one = sightings_.end() - 1;
    }
    (feature.side == Side::left ? one->left : one->right) = feature.label;
  }
}

/// Where the road's course is known less well than drivers keep to it, it goes the way they go, and the way
/// the car itself goes.
void VehicleUpdate::take_headings(double seconds, RoadState& state) const {
  const double repeats = std::max(1.0, 2 * kHeadingTau / std::max(seconds, 0.01));
  const auto take = [&](const Eigen::Vector2d& place, double heading, double variance) {
    const double station = state.axis().project(place).place.station;
    if (heading_variance(station, state) > variance) take_heading(place, heading, repeats * variance, state);
  };
  take(Eigen::Vector2d::Zero(), 0, square(kOwnHeading));
  for (const Sighting& sighting : sightings_) {
    if (!sighting.changing_lane) take(sighting.middle, sighting.heading, sighting.heading_variance);
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
  take_headings(taken_at_ ? to_seconds(set.measured_at - *taken_at_) : 0, state);
  taken_at_ = set.measured_at;
  if (!config_.range_order) before_frame_.emplace(state).rebuild_axis();
  std::size_t used = 0;
  for (const Sighting& sighting : sightings_) {
    if (take_one(sighting, set.measured_at, state)) ++used;
  }
  return used;
}

/// What a vehicle's place is compared with: the middle of its lane, or, where nobody can say which lane it is
/// in, the nearest line. Nothing where no line is.
std::optional<VehicleUpdate::Reference> VehicleUpdate::reference_of(const Sighting& sighting,
                                                                    const RoadAxis::Foot& foot,
                                                                    const RoadState& state) {
  const auto& lines = state.lines();
  Reference lane;
  if (config_.association == RoadAssociation::labelled && sighting.left >= 0) {
    const auto labelled = [&lines](LineLabel label) {
      return static_cast<std::size_t>(
          std::find_if(lines.begin(), lines.end(), [label](const KnownLine& l) { return l.label == label; }) -
          lines.begin());
    };
    lane = {labelled(sighting.left), labelled(sighting.right), true};
    if (lane.left == lines.size() || lane.right == lines.size()) return std::nullopt;
    return lane;
  }
  const double station = foot.place.station;
  lane.in_lane = lane_at(state, station, foot.lateral, lane.left, lane.right);
  if (!lane.in_lane) strays_.push_back(sighting);
  const auto known = find(sighting.track_id, state);
  const bool settled = known != state.vehicles().end() && known->in_lane;
  if (lane.in_lane && (settled || is_certain(state, foot, lines[lane.left], lines[lane.right]))) return lane;
  double nearest = kFarthestLine;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double away = std::abs(state.offset(lines[i], station) - foot.lateral);
    if (away >= nearest) continue;
    nearest = away;
    lane = {i, i, false};
  }
  if (nearest == kFarthestLine) return std::nullopt;
  return lane;
}

std::vector<RoadVehicle>::const_iterator VehicleUpdate::find(std::int64_t track_id, const RoadState& state) {
  return std::find_if(state.vehicles().begin(), state.vehicles().end(),
                      [track_id](const RoadVehicle& vehicle) { return vehicle.track_id == track_id; });
}

void VehicleUpdate::forget(std::int64_t track_id, RoadState& state) {
  const auto known = find(track_id, state);
  if (known == state.vehicles().end()) return;
  state.remove_vehicle(static_cast<std::size_t>(known - state.vehicles().begin()));
}

/// The vehicle as it is known, or anew where it is in another lane than it was.
RoadVehicle* VehicleUpdate::vehicle_of(const Sighting& sighting, const Reference& reference, double aside,
                                       Time now, RoadState& state) const {
  const std::uint64_t left = state.lines()[reference.left].id;
  const std::uint64_t right = state.lines()[reference.right].id;
  const auto known = find(sighting.track_id, state);
  if (known != state.vehicles().end() && known->in_lane == reference.in_lane && known->left == left &&
      known->right == right) {
    return &state.vehicles()[static_cast<std::size_t>(known - state.vehicles().begin())];
  }
  forget(sighting.track_id, state);
  RoadVehicle* vehicle = reference.in_lane ? state.add_vehicle(sighting.track_id)
                                           : state.add_stranger(sighting.track_id, aside, kStrangerSigma);
  if (!vehicle) return nullptr;
  vehicle->left = left;
  vehicle->right = right;
  vehicle->seen = now - from_seconds(config_.vehicles.sensor.tau);
  return vehicle;
}

bool VehicleUpdate::take_one(const Sighting& sighting, Time now, RoadState& state) {
  state.rebuild_axis();
  const bool switchable = config_.vehicles.switchable;
  if ((switchable && sighting.changing_lane) || sighting.left == kNoLine || sighting.right == kNoLine) {
    forget(sighting.track_id, state);
    return true;
  }
  const RoadAxis::Foot foot = state.axis().project(sighting.middle);
  const RoadState& known = before_frame_ ? *before_frame_ : state;
  const auto reference = reference_of(sighting, known.axis().project(sighting.middle), known);
  if (!reference) return false;
  KnownLine& left = state.lines()[reference->left];
  KnownLine& right = state.lines()[reference->right];
  const double station = foot.place.station;
  const double aside = foot.lateral - (state.offset(left, station) + state.offset(right, station)) / 2;
  RoadVehicle* vehicle = vehicle_of(sighting, *reference, aside, now, state);
  if (!vehicle) return false;
  SparseRow row;
  state.add_lateral(row, foot.place);
  state.add_offset(row, left, station, -0.5);
  state.add_offset(row, right, station, -0.5);
  row.add(vehicle->index, -1);
  row.add(kVehicleYaw, -sighting.range);
  const double residual =
      aside - state.numbers().mean(vehicle->index) - sighting.range * state.numbers().mean(kVehicleYaw);
  // Looks that follow each other within the time for which a track errs the same way say little new.
  const double seconds = std::max(0.01, to_seconds(now - vehicle->seen));
  const double repeats = std::max(1.0, 2 * config_.vehicles.sensor.tau / seconds);
  const double own = std::max(sighting.variance - square(config_.vehicles.driver.sigma),
                              square(config_.vehicles.sensor.sigma) / 4);
  const double expected = state.numbers().variance(row) + own;
  const double fresh = std::min(1.0, seconds / config_.vehicles.sensor.tau);
  vehicle->surprise += fresh * (square(residual) / expected - vehicle->surprise);
  vehicle->seen = now;
  const bool between = reference->in_lane && std::abs(aside) > kAway + std::sqrt(expected);
  if (switchable && (vehicle->surprise > kSurprising || between)) {
    if (!reference->in_lane) forget(sighting.track_id, state);
    return true;
  }
  const double doubt = switchable ? square(std::max(1.0, vehicle->surprise)) : 1;
  state.numbers().update(row, -residual, own * repeats * doubt);
  if (!reference->in_lane) return true;
  ++left.witnessed;
  ++right.witnessed;
  left.traffic_on_right += 1;
  right.traffic_on_left += 1;
  return true;
}

}  // namespace lanefuse
