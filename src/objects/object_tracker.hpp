// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/assignment.hpp"
#include "core/pose2.hpp"
#include "objects/barrier_watch.hpp"
#include "objects/lane_change_watch.hpp"
#include "objects/lost_tracks.hpp"
#include "objects/object_track.hpp"
#include "objects/object_tracker_config.hpp"
#include "objects/sighting.hpp"
#include "objects/sighting_clusters.hpp"
#include "objects/track_sight.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// Fuses what radars and cameras see of other vehicles into tracks [IROS16, sec. II-C]: a Kalman filter a
/// vehicle, global nearest neighbours, an existence that every look raises or lowers, and a verification for
/// each kind of sensor. No allocation once as many tracks and looks have been held as ever will.
class ObjectTracker {
 public:
  explicit ObjectTracker(const ObjectTrackerConfig& config) : config_(config) {}

  /// Takes a look in. One that comes late, by no more than the window, counts as if it had come in time: what
  /// came after it is gone through again. False, and nothing changed, for one that is older.
  bool add(const SightingSet& look);

  /// The confirmed tracks, moved on to `time`, in the vehicle frame: driving vehicles, vehicles that stopped,
  /// and standing ones that a camera has verified.
  void write(Time time, const Pose2& odometry_from_vehicle, std::vector<TrackedObject>& objects) const;

  void reset();

 private:
  struct State {
    std::optional<Time> time;
    std::int64_t next_id = 1;
    std::vector<ObjectTrack> tracks;
    LostTracks lost;
    BarrierWatch barriers;
    RoadCourse course;  ///< as of `time`
  };
  struct Entry {
    State before;
    SightingSet look;
  };

  const ObjectTrackerConfig config_;
  State state_;
  std::vector<Entry> history_;  ///< in order of time; the first `held_` of them hold something
  std::size_t held_ = 0;

  /// Instead of a track's index: a part of some vehicle that is known, of no use beside.
  static constexpr int kKnown = -2;

  // Workspaces of one look.
  SightingClusters clusters_;
  TrackSight sight_;
  Assignment assignment_;
  std::vector<double> costs_;
  std::vector<int> track_of_;  ///< of each sighting, Assignment::kAlone, or kKnown
  LaneChangeWatch lane_changes_;

  void forget_history();
  void process(const SightingSet& look);
  [[nodiscard]] double curvature_at(const ObjectTrack& track, const Pose2& odometry_from_vehicle) const;
  void predict_all(const SightingSet& look);
  void associate(const SightingSet& look);
  void leave_to_known(const SightingSet& look, const Sighting& sighting);
  [[nodiscard]] double cost(const ObjectTrack& track, const SightingSet& look,
                            const Sighting& sighting) const;
  bool take(std::size_t index, const SightingSet& look);
  void miss(ObjectTrack& track, const SightingSet& look, double detection) const;
  void start_tracks(const SightingSet& look);
  bool belongs_to_known(const SightingSet& look, const Sighting& sighting);
  void judge(const SightingSet& look);
  void refuse_mirrors(const SightingSet& look);
  [[nodiscard]] bool is_beyond_barrier(const ObjectTrack& track, const Pose2& vehicle_from_odometry) const;
  void forget(Time now);
};

}  // namespace lanefuse
