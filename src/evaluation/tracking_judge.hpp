// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/assignment.hpp"
#include "evaluation/identity_overlap.hpp"
#include "evaluation/tracking_figures.hpp"
#include "sensors/measurement.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

struct TrackingJudgeConfig {
  double range_ahead = 150;      ///< [m] from the origin, of vehicles whose rear is ahead of it
  double range_behind = 50;      ///< [m] the same behind it
  double near_range = 100;       ///< [m] of the figures for nearby vehicles
  double hidden_s = 2;           ///< [s] a hidden vehicle is still to be tracked
  double least_in_sight = 0.33;  ///< share of its width below which a vehicle is hidden
  double gate = 4;            ///< [m] from rear to rear, at most, for a track to be on a vehicle; GOSPA's c
  double witness_across = 2;  ///< [m] from a true vehicle, at most, for a witness to be one
  double witness_along = 8;   ///< [m]
  double patience_s = 2;      ///< [s] in sight after which a vehicle should have had a track
};

/// Judges tracks by the true vehicles, frame by frame.
///
/// A vehicle counts in a frame that is in range and has not been hidden by others for longer than `hidden_s`;
/// else it is ignored: a track on it is neither right nor wrong. So are tracks out of range on no vehicle.
/// Everything is measured at the middle of the rear.
///
/// GOSPA [Rahmathullah et al., 2017] with c = gate, p = 2, alpha = 2 has the pairs that make it least. For
/// everything else a vehicle keeps its track as long as that is within the gate, and the others get the pairs
/// that are nearest in sum, as in CLEAR MOT.
class TrackingJudge {
 public:
  explicit TrackingJudge(const TrackingJudgeConfig& config) : config_(config) {}

  /// One frame, in order of time, and the tracks at its time in the vehicle frame. Ids are of one drive: use
  /// one judge a drive, and add up the figures.
  void add(const TrueFrame& truth, std::span<const TrackedObject> objects);

  [[nodiscard]] TrackingFigures figures() const;

 private:
  /// What is remembered of a true vehicle.
  struct Vehicle {
    Time frame{};                       ///< in which it was last
    std::optional<Time> last_in_sight;  ///< since it came into view
    std::optional<Time> first_counted;
    double counted_s = 0;  ///< [s] that it has counted
    bool confirmed = false;
    bool last_counted = false;
    std::int64_t visit = 0;  ///< how often it has begun to count: each time it may be taken for another
    std::optional<std::int64_t> current;  ///< the track that was on it in the last frame
    std::optional<std::int64_t> last;     ///< the last track that was on it since it began to count
  };
  /// What is remembered of a track.
  struct TrackLife {
    std::uint64_t frames = 0;
    std::uint64_t frames_on_vehicle = 0;
    bool witness = false;
    bool false_witness = false;
  };
  /// A true vehicle in this frame.
  struct SeenVehicle {
    std::int64_t id = 0;
    Pose2 rear;  ///< in the vehicle frame
    bool counts = false;
    Vehicle* memory = nullptr;
  };

  [[nodiscard]] bool in_range(const Eigen::Vector2d& place) const;
  void look(const TrueFrame& truth);
  [[nodiscard]] double distance(std::size_t vehicle, std::size_t track) const;
  void pair_tracks();
  void judge_pairs(double seconds);
  void judge_hit(const SeenVehicle& vehicle, const TrackedObject& track);
  void judge_gospa();
  void judge_lives();
  [[nodiscard]] bool is_at_a_vehicle(const TrackedObject& track) const;
  template <typename Tally>
  void count(double range, Tally tally);

  TrackingJudgeConfig config_;
  TrackingFigures sums_;
  std::optional<Time> last_time_;
  std::map<std::int64_t, Vehicle> vehicles_;
  std::map<std::int64_t, TrackLife> lives_;
  IdentityOverlap overlap_;
  IdentityOverlap near_overlap_;

  // Of the frame that is being judged.
  Time time_{};
  std::span<const TrackedObject> tracks_;
  std::vector<SeenVehicle> seen_;
  std::vector<int> track_of_;    ///< [vehicle]
  std::vector<int> vehicle_of_;  ///< [track]
  Assignment assignment_;
};

}  // namespace lanefuse
