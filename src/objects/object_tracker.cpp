// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "objects/known_body.hpp"
#include "objects/track_relations.hpp"
#include "objects/track_report.hpp"

namespace lanefuse {
namespace {

/// Looks of one moment are taken in the order of their sensors, however they came.
auto key(const SightingSet& look) { return std::pair(look.measured_at, look.sensor_id); }

}  // namespace

bool ObjectTracker::add(const SightingSet& look) {
  forget_history();
  const auto known = history_.begin() + static_cast<std::ptrdiff_t>(held_);
  if (std::any_of(history_.begin(), known, [&](const Entry& e) { return key(e.look) == key(look); })) {
    return false;
  }
  const bool late = state_.time && look.measured_at < *state_.time;
  if (late && (held_ == 0 || *state_.time - look.measured_at > from_seconds(config_.window_s))) return false;
  if (held_ == history_.size()) history_.emplace_back();
  history_[held_].look = look;
  std::size_t place = held_++;
  while (place > 0 && key(look) < key(history_[place - 1].look)) {
    std::swap(history_[place], history_[place - 1]);
    --place;
  }
  // Everything from here on is gone through again, from the tracks as they were before.
  if (place + 1 < held_) state_ = history_[place + 1].before;
  for (; place < held_; ++place) {
    history_[place].before = state_;
    process(history_[place].look);
  }
  return true;
}

void ObjectTracker::forget_history() {
  if (held_ == 0) return;
  const Time newest = history_[held_ - 1].look.measured_at;
  const Duration window = from_seconds(config_.window_s);
  std::size_t old = 0;
  while (old + 1 < held_ && newest - history_[old].look.measured_at > window) ++old;
  // Entries are kept for their memory, and only change places.
  std::rotate(history_.begin(), history_.begin() + static_cast<std::ptrdiff_t>(old),
              history_.begin() + static_cast<std::ptrdiff_t>(held_));
  held_ -= old;
}

void ObjectTracker::process(const SightingSet& look) {
  predict_all(look);
  sight_.look(look, state_.tracks);
  associate(look);
  for (std::size_t i = 0; i < state_.tracks.size(); ++i) {
    if (!take(i, look)) miss(state_.tracks[i], look, sight_.detection(i));
  }
  start_tracks(look);
  judge(look);
}

void ObjectTracker::predict_all(const SightingSet& look) {
  const double seconds = state_.time ? to_seconds(look.measured_at - *state_.time) : 0;
  state_.time = look.measured_at;
  state_.barriers.look(look, seconds);
  if (seconds <= 0) return;
  const auto move_on = [&](ObjectTrack& track) {
    predict(track, seconds, look.odometry_from_vehicle.position(),
            curvature_at(track, look.odometry_from_vehicle), config_);
  };
  std::ranges::for_each(state_.tracks, move_on);
  std::ranges::for_each(state_.lost.tracks(), move_on);
  state_.course = lane_changes_.course(look, config_, state_.tracks);
  lane_changes_.mark(look, seconds, state_.course, config_, state_.tracks);
}

/// [1/m] Of the road where the track is, if it drives our way along it.
double ObjectTracker::curvature_at(const ObjectTrack& track, const Pose2& odometry_from_vehicle) const {
  constexpr double kOurWay = 0.5;  // [rad]
  constexpr double kReach = 200;   // [m]
  const bool seen = *state_.time - track.last_seen < from_seconds(config_.gap_s);
  if (seen || track.speed() < config_.min_speed) return 0;
  const Pose2 vehicle_from_odometry = odometry_from_vehicle.inverse();
  if (std::abs(wrap_angle(track.heading + vehicle_from_odometry.heading)) > kOurWay) return 0;
  const double x = (vehicle_from_odometry * track.position()).x();
  return std::abs(x) < kReach ? state_.course.curvature(x) : 0;
}

void ObjectTracker::associate(const SightingSet& look) {
  const auto sightings = static_cast<int>(look.sightings.size());
  const auto tracks = static_cast<int>(state_.tracks.size());
  costs_.clear();
  for (const Sighting& sighting : look.sightings) {
    for (const ObjectTrack& track : state_.tracks) costs_.push_back(cost(track, look, sighting));
    if (look.kind == SightingKind::radar) leave_to_known(look, sighting);
  }
  // Staying alone costs more than the worst fit within the gates: it is the number of pairs that counts
  // first.
  constexpr double kAlone = 60;
  const auto assigned = assignment_.solve(sightings, tracks, std::span<const double>(costs_), kAlone);
  track_of_.assign(assigned.begin(), assigned.end());
  // What is left over is one more reflection of the vehicle that it fits best.
  for (std::size_t i = 0; i < track_of_.size(); ++i) {
    if (track_of_[i] != Assignment::kAlone || look.kind == SightingKind::camera) continue;
    const auto row = costs_.begin() + static_cast<std::ptrdiff_t>(i * state_.tracks.size());
    const auto best = std::min_element(row, row + tracks);
    if (tracks > 0 && *best != Assignment::kForbidden) track_of_[i] = static_cast<int>(best - row);
  }
}

/// A vehicle gives many reflections, and their bearings err: what a known track explains well must not feed a
/// new one beside it. The sighting's costs are the last ones.
void ObjectTracker::leave_to_known(const SightingSet& look, const Sighting& sighting) {
  const auto& tracks = state_.tracks;
  const auto explains = [&](const ObjectTrack& track) {
    if (!track.confirmed || look.measured_at - track.last_seen > from_seconds(config_.gap_s)) return false;
    const std::size_t index =
        costs_.size() - tracks.size() + static_cast<std::size_t>(&track - tracks.data());
    return costs_[index] != Assignment::kForbidden &&
           misfit(track, observe(track, look, sighting, config_)).distance_squared < config_.sure_gate;
  };
  if (std::none_of(tracks.begin(), tracks.end(), explains)) return;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (!tracks[i].confirmed) costs_[costs_.size() - tracks.size() + i] = Assignment::kForbidden;
  }
}

double ObjectTracker::cost(const ObjectTrack& track, const SightingSet& look,
                           const Sighting& sighting) const {
  constexpr double kFurthest = 25;    // [m] beyond which nothing belongs to a track, whatever its doubts
  constexpr double kSameAddress = 9;  // as much as three sigmas: the radar's own word
  const TrackObservation observation = observe(track, look, sighting, config_);
  if (observation.residual.head<2>().squaredNorm() > kFurthest * kFurthest) return Assignment::kForbidden;
  const Misfit fit = misfit(track, observation);
  const bool same_address = sighting.address && sighting.address == track.address;
  if (fit.distance_squared > (same_address ? 2 : 1) * config_.gate) return Assignment::kForbidden;
  return fit.distance_squared + fit.log_volume - (same_address ? kSameAddress : 0);
}

/// Whether the look saw the track.
bool ObjectTracker::take(std::size_t index, const SightingSet& look) {
  ObjectTrack& track = state_.tracks[index];
  double confidence = 0;
  for (std::size_t i = 0; i < track_of_.size(); ++i) {
    if (track_of_[i] != static_cast<int>(index)) continue;
    update(track, look, look.sightings[i], config_);
    confidence = std::max(confidence, look.sightings[i].confidence);
  }
  if (confidence <= 0) return false;
  if (track.speed() > config_.min_speed) {
    const Eigen::Vector2d velocity = track.velocity();
    track.heading = std::atan2(velocity.y(), velocity.x());
  }
  const double evidence = config_.hit_odds * confidence;
  track.odds = std::min(track.odds + evidence, config_.most_odds);
  Verification& verification = look.kind == SightingKind::radar ? track.radar : track.camera;
  verification.add(evidence, config_);
  verification.last = look.measured_at;
  track.run = look.measured_at - track.last_seen > from_seconds(config_.gap_s) ? 1 : track.run + 1;
  track.last_seen = track.last_due = look.measured_at;
  ++track.hits;
  return true;
}

void ObjectTracker::miss(ObjectTrack& track, const SightingSet& look, double detection) const {
  if (detection <= 0) return;
  constexpr double kSurest = 0.98;
  const double evidence = config_.miss_share * std::log(1 - std::min(detection, kSurest));
  track.odds += evidence;
  (look.kind == SightingKind::radar ? track.radar : track.camera).add(evidence, config_);
  track.last_due = look.measured_at;
}

void ObjectTracker::start_tracks(const SightingSet& look) {
  for (std::size_t i = 0; i < track_of_.size(); ++i) {
    if (track_of_[i] == Assignment::kAlone && belongs_to_known(look, look.sightings[i]))
      track_of_[i] = kKnown;
  }
  clusters_.find(look, track_of_, config_);
  for (int c = 0; c < clusters_.count(); ++c) {
    const Sighting& nearest = look.sightings[static_cast<std::size_t>(clusters_.members(c).front())];
    ObjectTrack track = start_track(look, nearest, config_, look.odometry_from_vehicle.heading);
    track.id = state_.next_id++;
    track.born = track.last_seen = track.last_due = look.measured_at;
    track.hits = track.run = 1;
    state_.tracks.push_back(track);
  }
}

bool ObjectTracker::belongs_to_known(const SightingSet& look, const Sighting& sighting) {
  return std::any_of(state_.tracks.begin(), state_.tracks.end(), [&](ObjectTrack& track) {
    return track.confirmed && is_on_body(track, look, sighting, config_);
  });
}

void ObjectTracker::judge(const SightingSet& look) {
  for (ObjectTrack& track : state_.tracks) {
    if (!track.confirmed && track.odds > config_.confirm_odds && track.hits >= config_.confirm_hits) {
      track.confirmed = true;
      track.confirmed_at = look.measured_at;
    }
    if (track.confirmed && !track.superseded) {
      state_.lost.know_again(track, look.measured_at, state_.tracks, config_);
    }
    if (track.confirmed && surely_drives(track, config_.min_speed)) track.has_moved = true;
    track.refused = track.camera.odds < config_.refused_odds;
  }
  refuse_mirrors(look);
  merge_doubles(state_.tracks, config_.same_along);
  forget(look.measured_at);
}

void ObjectTracker::refuse_mirrors(const SightingSet& look) {
  const Pose2 vehicle_from_odometry = look.odometry_from_vehicle.inverse();
  for (ObjectTrack& ghost : state_.tracks) {
    if (ghost.camera.verified || !ghost.confirmed) continue;
    ghost.refused = ghost.refused || is_beyond_barrier(ghost, vehicle_from_odometry);
    for (const ObjectTrack& real : state_.tracks) {
      if (&real == &ghost || !real.confirmed || real.refused) continue;
      if (is_mirror_of(ghost, real, look.odometry_from_vehicle.position())) ghost.refused = true;
    }
  }
}

bool ObjectTracker::is_beyond_barrier(const ObjectTrack& track, const Pose2& vehicle_from_odometry) const {
  constexpr double kBeyond = 0.7;  // [m]
  constexpr double kOurWay = 0.5;  // [rad]
  if (std::abs(wrap_angle(track.heading + vehicle_from_odometry.heading)) > kOurWay) return false;
  const RoadCourse::Estimate offset = state_.course.offset(vehicle_from_odometry * track.position());
  const double margin = kBeyond + 2 * offset.sigma;
  return offset.value > state_.barriers.left() + margin || offset.value < state_.barriers.right() - margin;
}

void ObjectTracker::forget(Time now) {
  constexpr double kGone = -2;  // log odds
  const auto is_over = [&](const ObjectTrack& track) {
    const double unseen = to_seconds(now - track.last_seen);
    if (!track.confirmed) return track.odds < kGone || unseen > config_.tentative_coast_s;
    const bool due = track.last_due > track.last_seen;
    return (unseen > config_.coast_s && (due && track.odds < config_.confirm_odds)) ||
           unseen > config_.hidden_coast_s;
  };
  for (const ObjectTrack& track : state_.tracks) {
    if (is_over(track)) state_.lost.add(track);
  }
  std::erase_if(state_.tracks, is_over);
  state_.lost.forget(now, config_);
}

void ObjectTracker::write(Time time, const Pose2& odometry_from_vehicle,
                          std::vector<TrackedObject>& objects) const {
  objects.clear();
  const Pose2 vehicle_from_odometry = odometry_from_vehicle.inverse();
  for (const ObjectTrack& known : state_.tracks) {
    const bool is_vehicle = known.has_moved || known.camera.verified;
    if (!known.confirmed || known.refused || !is_vehicle) continue;
    ObjectTrack track = known;
    const double seconds = to_seconds(time - *state_.time);
    if (seconds > 0) {
      predict(track, seconds, odometry_from_vehicle.position(), curvature_at(track, odometry_from_vehicle),
              config_);
    }
    objects.push_back(described(track, vehicle_from_odometry, config_));
  }
}

void ObjectTracker::reset() {
  state_.time.reset();
  state_.next_id = 1;
  state_.tracks.clear();
  state_.lost.clear();
  state_.barriers = {};
  state_.course = {};
  held_ = 0;
}

}  // namespace lanefuse
