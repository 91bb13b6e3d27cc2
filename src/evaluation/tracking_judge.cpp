// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/tracking_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evaluation/true_frames.hpp"
#include "evaluation/vehicle_sight.hpp"

namespace lanefuse {
namespace {

constexpr double kHour = 3600;  // [s]

Eigen::Vector2d place_of(const TrackedObject& track) { return {track.x, track.y}; }

}  // namespace

void TrackingJudge::add(const TrueFrame& truth, std::span<const TrackedObject> objects) {
  const Duration step = last_time_ ? truth.time - *last_time_ : Duration{};
  const double seconds = step <= kLargestFrameGap ? to_seconds(step) : 0;
  time_ = truth.time;
  tracks_ = objects;
  look(truth);
  pair_tracks();
  judge_pairs(seconds);
  judge_gospa();
  judge_lives();
  ++sums_.frames;
  sums_.hours += seconds / kHour;
  sums_.objects += objects.size();
  last_time_ = truth.time;
}

bool TrackingJudge::in_range(const Eigen::Vector2d& place) const {
  return place.norm() <= (place.x() > 0 ? config_.range_ahead : config_.range_behind);
}

/// Finds out which vehicles count.
void TrackingJudge::look(const TrueFrame& truth) {
  seen_.clear();
  const Pose2 vehicle_from_world = truth.world_from_vehicle.inverse();
  const std::vector<double> shares = shares_in_sight(truth);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const TrueObject& object = truth.objects[i];
    Vehicle& memory = vehicles_[object.id];
    if (memory.frame != last_time_) {
      memory.last_in_sight.reset();
      memory.current.reset();
    }
    memory.frame = time_;
    if (shares[i] >= config_.least_in_sight) memory.last_in_sight = time_;
    const Pose2 rear = vehicle_from_world * object.world_from_object;
    const bool in_sight =
        memory.last_in_sight && time_ - *memory.last_in_sight <= from_seconds(config_.hidden_s);
    const bool counts = in_sight && in_range(rear.position());
    // Who was out of sight may come back under another id: nobody can know it for the same.
    if (counts && !memory.last_counted) ++memory.visit;
    memory.last_counted = counts;
    if (!counts) memory.last.reset();
    seen_.push_back({object.id, rear, counts, &memory});
  }
}

double TrackingJudge::distance(std::size_t vehicle, std::size_t track) const {
  return (seen_[vehicle].rear.position() - place_of(tracks_[track])).norm();
}

void TrackingJudge::pair_tracks() {
  track_of_.assign(seen_.size(), Assignment::kAlone);
  vehicle_of_.assign(tracks_.size(), Assignment::kAlone);
  const auto pair = [this](std::size_t vehicle, std::size_t track) {
    track_of_[vehicle] = static_cast<int>(track);
    vehicle_of_[track] = static_cast<int>(vehicle);
  };
  for (std::size_t vehicle = 0; vehicle < seen_.size(); ++vehicle) {
    const auto& current = seen_[vehicle].memory->current;
    for (std::size_t track = 0; current && track < tracks_.size(); ++track)
      if (tracks_[track].id == *current && distance(vehicle, track) <= config_.gate) pair(vehicle, track);
  }
  const auto cost = [this](int row, int column) {
    const auto vehicle = static_cast<std::size_t>(row);
    const auto track = static_cast<std::size_t>(column);
    const bool free = track_of_[vehicle] == Assignment::kAlone && vehicle_of_[track] == Assignment::kAlone;
    const double apart = distance(vehicle, track);
    return free && apart <= config_.gate ? apart : Assignment::kForbidden;
  };
  // As many pairs as can be, whatever they cost.
  const double skip = config_.gate * static_cast<double>(seen_.size() + 1);
  const auto columns =
      assignment_.solve(static_cast<int>(seen_.size()), static_cast<int>(tracks_.size()), cost, skip);
  for (std::size_t vehicle = 0; vehicle < seen_.size(); ++vehicle)
    if (columns[vehicle] != Assignment::kAlone) pair(vehicle, static_cast<std::size_t>(columns[vehicle]));
}

template <typename Tally>
void TrackingJudge::count(double range, Tally tally) {
  tally(sums_.all, overlap_);
  if (range <= config_.near_range) tally(sums_.near, near_overlap_);
}

void TrackingJudge::judge_pairs(double seconds) {
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const SeenVehicle& vehicle = seen_[i];
    Vehicle& memory = *vehicle.memory;
    const bool hit = track_of_[i] != Assignment::kAlone;
    memory.current.reset();
    if (hit) memory.current = tracks_[static_cast<std::size_t>(track_of_[i])].id;
    if (!vehicle.counts) continue;
    count(vehicle.rear.position().norm(), [&](TrackingCounts& counts, IdentityOverlap&) {
      ++counts.vehicles;
      counts.vehicle_hours += seconds / kHour;
    });
    if (!memory.first_counted) memory.first_counted = time_;
    memory.counted_s += seconds;
    if (hit) judge_hit(vehicle, tracks_[static_cast<std::size_t>(track_of_[i])]);
  }
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (vehicle_of_[i] != Assignment::kAlone || !in_range(place_of(tracks_[i]))) continue;
    count(place_of(tracks_[i]).norm(),
          [](TrackingCounts& counts, IdentityOverlap&) { ++counts.false_tracks; });
  }
  // For the identities a track is on whatever vehicle it is near, not only on the one it was paired with.
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const bool ignored = vehicle_of_[i] == Assignment::kAlone
                             ? !in_range(place_of(tracks_[i]))
                             : !seen_[static_cast<std::size_t>(vehicle_of_[i])].counts;
    for (std::size_t j = 0; !ignored && j < seen_.size(); ++j) {
      if (!seen_[j].counts || distance(j, i) > config_.gate) continue;
      count(seen_[j].rear.position().norm(), [&](TrackingCounts&, IdentityOverlap& overlap) {
        const std::int64_t visit = seen_[j].memory->visit;
        overlap.add({seen_[j].id, visit}, {tracks_[i].id, visit});
      });
    }
  }
}

void TrackingJudge::judge_hit(const SeenVehicle& vehicle, const TrackedObject& track) {
  Vehicle& memory = *vehicle.memory;
  const bool switched = memory.last && *memory.last != track.id;
  memory.last = track.id;
  count(vehicle.rear.position().norm(), [switched](TrackingCounts& counts, IdentityOverlap&) {
    ++counts.hits;
    if (switched) ++counts.id_switches;
  });
  if (!std::exchange(memory.confirmed, true)) {
    sums_.confirm_s.add(to_seconds(time_ - *memory.first_counted));
    ++sums_.confirmed;
  }
  const auto bin = static_cast<std::size_t>(std::max(0.0, vehicle.rear.x) / TrackingFigures::kBinLength);
  if (vehicle.rear.x < 0 || bin >= TrackingFigures::kBins) return;
  const Eigen::Matrix2d turn = rotation(vehicle.rear.heading);
  const Eigen::Vector2d across = turn.col(1);
  const double variance = across.dot(track.covariance.topLeftCorner<2, 2>() * across);
  sums_.ahead[bin].add(across.dot(place_of(track) - vehicle.rear.position()), std::sqrt(variance),
                       wrap_angle(track.heading - vehicle.rear.heading));
}

void TrackingJudge::judge_gospa() {
  const double alone = config_.gate * config_.gate / 2;
  // Relative to both staying alone, so that a row's cost does not depend on what its column would cost.
  const auto gain = [&](int row, int column) {
    const double apart = distance(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
    return apart < config_.gate ? apart * apart - 2 * alone : Assignment::kForbidden;
  };
  const auto columns =
      assignment_.solve(static_cast<int>(seen_.size()), static_cast<int>(tracks_.size()), gain, 0);
  std::vector<char> paired(tracks_.size(), 0);
  double localisation = 0;
  double missed = 0;
  double wrong = 0;
  for (std::size_t vehicle = 0; vehicle < seen_.size(); ++vehicle) {
    const bool hit = columns[vehicle] != Assignment::kAlone;
    if (hit) paired[static_cast<std::size_t>(columns[vehicle])] = 1;
    if (!seen_[vehicle].counts) continue;
    if (!hit) missed += alone;
    const double apart = hit ? distance(vehicle, static_cast<std::size_t>(columns[vehicle])) : 0;
    localisation += apart * apart;
  }
  for (std::size_t track = 0; track < tracks_.size(); ++track)
    if (paired[track] == 0 && in_range(place_of(tracks_[track]))) wrong += alone;
  sums_.gospa_sum += std::sqrt(localisation + missed + wrong);
  sums_.localisation_sum += localisation;
  sums_.missed_sum += missed;
  sums_.false_sum += wrong;
}

void TrackingJudge::judge_lives() {
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const TrackedObject& track = tracks_[i];
    if (track.witness) {
      TrackLife& life = lives_[track.id];
      life.witness = true;
      life.false_witness = life.false_witness || !is_at_a_vehicle(track);
    }
    if (!in_range(place_of(track))) continue;
    TrackLife& life = lives_[track.id];
    ++life.frames;
    bool on_vehicle = false;
    for (std::size_t vehicle = 0; vehicle < seen_.size(); ++vehicle)
      on_vehicle = on_vehicle || distance(vehicle, i) <= config_.gate;
    if (on_vehicle) ++life.frames_on_vehicle;
  }
}

bool TrackingJudge::is_at_a_vehicle(const TrackedObject& track) const {
  return std::any_of(seen_.begin(), seen_.end(), [&](const SeenVehicle& vehicle) {
    const Eigen::Vector2d off = vehicle.rear.inverse() * place_of(track);
    return std::abs(off.x()) <= config_.witness_along && std::abs(off.y()) <= config_.witness_across;
  });
}

TrackingFigures TrackingJudge::figures() const {
  TrackingFigures figures = sums_;
  figures.near_range = config_.near_range;
  figures.all.id_hits = overlap_.id_hits();
  figures.near.id_hits = near_overlap_.id_hits();
  for (const auto& [id, life] : lives_) {
    if (life.frames > 0) ++figures.tracks;
    if (2 * life.frames_on_vehicle < life.frames) ++figures.false_confirmed;
    if (life.witness) ++figures.witnesses;
    if (life.false_witness) ++figures.false_witnesses;
  }
  for (const auto& [id, vehicle] : vehicles_)
    if (!vehicle.confirmed && vehicle.counted_s >= config_.patience_s) ++figures.never_confirmed;
  return figures;
}

}  // namespace lanefuse
