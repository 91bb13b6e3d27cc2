// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
  clusters_.find(look, config_);
  sight_.look(look, state_.tracks);
  associate(look);
  for (std::size_t i = 0; i < cluster_of_track_.size(); ++i) {
    const int cluster = cluster_of_track_[i];
    if (cluster == Assignment::kAlone) {
      miss(state_.tracks[i], look, sight_.detection(i));
    } else {
      take(state_.tracks[i], look, cluster);
    }
  }
  start_tracks(look);
  judge(look);
}

void ObjectTracker::predict_all(const SightingSet& look) {
  const double seconds = state_.time ? to_seconds(look.measured_at - *state_.time) : 0;
  state_.time = look.measured_at;
  if (seconds <= 0) return;
  for (ObjectTrack& track : state_.tracks) {
    predict(track, seconds, look.odometry_from_vehicle.position(), config_);
  }
  lane_changes_.look(look, seconds, config_, state_.tracks);
}

void ObjectTracker::associate(const SightingSet& look) {
  const int clusters = clusters_.count();
  const auto tracks = static_cast<int>(state_.tracks.size());
  costs_.clear();
  for (int c = 0; c < clusters; ++c) {
    for (const ObjectTrack& track : state_.tracks) costs_.push_back(cost(track, look, c));
  }
  // Staying alone costs more than the worst fit within the gates: it is the number of pairs that counts
  // first.
  constexpr double kAlone = 60;
  const auto assigned = assignment_.solve(clusters, tracks, std::span<const double>(costs_), kAlone);
  cluster_of_track_.assign(state_.tracks.size(), Assignment::kAlone);
  for (int c = 0; c < clusters; ++c) {
    const int track = assigned[static_cast<std::size_t>(c)];
    if (track != Assignment::kAlone) cluster_of_track_[static_cast<std::size_t>(track)] = c;
  }
}

/// That of the member that fits best.
double ObjectTracker::cost(const ObjectTrack& track, const SightingSet& look, int cluster) const {
  constexpr double kFurthest = 25;    // [m] beyond which nothing belongs to a track, whatever its doubts
  constexpr double kSameAddress = 9;  // as much as three sigmas: the radar's own word
  double best = Assignment::kForbidden;
  for (const int member : clusters_.members(cluster)) {
    const Sighting& sighting = look.sightings[static_cast<std::size_t>(member)];
    const TrackObservation observation = observe(track, look, sighting, config_);
    if (observation.residual.head<2>().squaredNorm() > kFurthest * kFurthest) continue;
    const Misfit fit = misfit(track, observation);
    const bool same_address = sighting.address && sighting.address == track.address;
    if (fit.distance_squared > (same_address ? 2 : 1) * config_.gate) continue;
    best = std::min(best, fit.distance_squared + fit.log_volume - (same_address ? kSameAddress : 0));
  }
  return best;
}

void ObjectTracker::take(ObjectTrack& track, const SightingSet& look, int cluster) {
  double confidence = 0;
  for (const int member : clusters_.members(cluster)) {
    const Sighting& sighting = look.sightings[static_cast<std::size_t>(member)];
    const Misfit fit = misfit(track, observe(track, look, sighting, config_));
    if (fit.distance_squared > 2 * config_.gate) continue;
    update(track, look, sighting, config_);
    confidence = std::max(confidence, sighting.confidence);
  }
  if (track.speed() > config_.min_speed) {
    const Eigen::Vector2d velocity = track.velocity();
    track.heading = std::atan2(velocity.y(), velocity.x());
  }
  const double evidence = config_.hit_odds * confidence;
  track.odds = std::min(track.odds + evidence, config_.most_odds);
  Verification& verification = look.kind == SightingKind::radar ? track.radar : track.camera;
  verification.add(evidence, config_);
  verification.last = look.measured_at;
  track.last_seen = track.last_due = look.measured_at;
  ++track.hits;
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
  // A cluster that no track took: new, unless it is one more part of a vehicle that is known.
  const std::size_t known = cluster_of_track_.size();
  for (int c = 0; c < clusters_.count(); ++c) {
    if (std::find(cluster_of_track_.begin(), cluster_of_track_.end(), c) != cluster_of_track_.end()) continue;
    const Sighting& nearest = look.sightings[static_cast<std::size_t>(clusters_.members(c).front())];
    if (belongs_to_known(look, nearest)) continue;
    ObjectTrack track = start_track(look, nearest, config_, look.odometry_from_vehicle.heading);
    track.id = state_.next_id++;
    track.last_seen = track.last_due = look.measured_at;
    track.hits = 1;
    state_.tracks.push_back(track);
  }
  cluster_of_track_.resize(known);
}

/// Within the body of a confirmed track, as fast as it is.
bool ObjectTracker::belongs_to_known(const SightingSet& look, const Sighting& sighting) const {
  constexpr double kAround = 1.2;  // [m] about the body
  const double angle = look.odometry_from_sensor.heading + sighting.bearing;
  const Eigen::Vector2d sight(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d place = look.odometry_from_sensor.position() + sighting.range * sight;
  const double doubt = 2 * std::max(sighting.range_sigma, sighting.bearing_sigma * sighting.range);
  return std::any_of(state_.tracks.begin(), state_.tracks.end(), [&](const ObjectTrack& track) {
    if (!track.confirmed) return false;
    const Eigen::Vector2d from_rear = place - track.position();
    const Eigen::Vector2d ahead(std::cos(track.heading), std::sin(track.heading));
    const double along = from_rear.dot(ahead);
    const double across = ahead.x() * from_rear.y() - ahead.y() * from_rear.x();
    const double speed = sighting.range_rate ? *sighting.range_rate + look.velocity.dot(sight) : 0;
    const bool as_fast =
        !sighting.range_rate || std::abs(speed - track.velocity().dot(sight)) < 2 * config_.same_range_rate;
    return as_fast && along > -kAround - doubt && along < track.length() + kAround + doubt &&
           std::abs(across) < track.width / 2 + kAround;
  });
}

void ObjectTracker::judge(const SightingSet& look) {
  for (ObjectTrack& track : state_.tracks) {
    if (track.odds > config_.confirm_odds && track.hits >= config_.confirm_hits) track.confirmed = true;
    if (track.confirmed && track.speed() > config_.min_speed) track.has_moved = true;
    track.refused = track.camera.odds < config_.refused_odds;
  }
  refuse_mirrors(look.odometry_from_vehicle.position());
  merge_doubles();
  forget(look.measured_at);
}

/// What drives exactly beside another, further out than roads of three lanes are wide, and was never seen by
/// a camera, is that other one in the mirror of a guard rail.
void ObjectTracker::refuse_mirrors(const Eigen::Vector2d& own_position) {
  constexpr double kBeside = 4;        // [m] along
  constexpr double kFurtherOut = 8.4;  // [m] at least: twice the way from a lane's middle to the rail
  constexpr double kFurthest = 45;     // [m]
  constexpr double kAsFast = 1.5;      // [m/s] along
  for (ObjectTrack& ghost : state_.tracks) {
    if (ghost.camera.verified || !ghost.confirmed) continue;
    const double ghost_range = (ghost.position() - own_position).norm();
    for (const ObjectTrack& real : state_.tracks) {
      if (&real == &ghost || !real.confirmed || real.refused) continue;
      const Eigen::Vector2d ahead(std::cos(real.heading), std::sin(real.heading));
      const Eigen::Vector2d apart = ghost.position() - real.position();
      const double along = std::abs(apart.dot(ahead));
      const double across = std::abs(ahead.x() * apart.y() - ahead.y() * apart.x());
      const double faster = std::abs((ghost.velocity() - real.velocity()).dot(ahead));
      const bool further = ghost_range + 1 > (real.position() - own_position).norm();
      if (along < kBeside && across > kFurtherOut && across < kFurthest && faster < kAsFast && further) {
        ghost.refused = true;
      }
    }
  }
}

/// Two tracks of one vehicle: the older one stays.
void ObjectTracker::merge_doubles() {
  constexpr double kAcross = 1.1;  // [m]
  constexpr double kAsFast = 1.5;  // [m/s]
  auto& tracks = state_.tracks;
  const auto is_double = [&](const ObjectTrack& young, const ObjectTrack& old) {
    if (young.id <= old.id || !old.confirmed) return false;
    const Eigen::Vector2d ahead(std::cos(old.heading), std::sin(old.heading));
    const Eigen::Vector2d apart = young.position() - old.position();
    const double along = apart.dot(ahead);
    const double across = ahead.x() * apart.y() - ahead.y() * apart.x();
    return std::abs(across) < kAcross && along > -0.5 * config_.same_along && along < old.length() - 0.5 &&
           (young.velocity() - old.velocity()).norm() < kAsFast;
  };
  for (ObjectTrack& young : tracks) {
    young.superseded = std::any_of(tracks.begin(), tracks.end(),
                                   [&](const ObjectTrack& old) { return is_double(young, old); });
  }
  std::erase_if(tracks, [](const ObjectTrack& track) { return track.superseded; });
}

void ObjectTracker::forget(Time now) {
  constexpr double kGone = -2;  // log odds
  std::erase_if(state_.tracks, [&](const ObjectTrack& track) {
    const double unseen = to_seconds(now - track.last_seen);
    if (!track.confirmed) return track.odds < kGone || unseen > config_.tentative_coast_s;
    const bool due = track.last_due > track.last_seen;
    return (unseen > config_.coast_s && (due && track.odds < config_.confirm_odds)) ||
           unseen > config_.hidden_coast_s;
  });
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
    if (seconds > 0) predict(track, seconds, odometry_from_vehicle.position(), config_);
    objects.push_back(described(track, vehicle_from_odometry, config_));
  }
}

void ObjectTracker::reset() {
  state_.time.reset();
  state_.next_id = 1;
  state_.tracks.clear();
  held_ = 0;
}

}  // namespace lanefuse
