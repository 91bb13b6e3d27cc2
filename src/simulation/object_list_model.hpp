// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>

#include "core/random.hpp"
#include "simulation/line_of_sight.hpp"
#include "simulation/preset.hpp"
#include "simulation/sensor_model.hpp"

namespace lanefuse {

/// What a production object fusion hands over: tracks whose errors last (they have been filtered), all turned
/// by the same misalignment. A vehicle hidden behind another is missed; hidden for long, it comes back as a
/// new track.
///
/// Witnesses: the radars see every vehicle in reach; the camera verifies those ahead within its own range,
/// frame by frame with its detection probability, and a track once verified stays so. Each is labelled with
/// the lines at its lane's edges: kNoLine while it is between two lanes, or in none.
class ObjectListModel final : public SensorModel {
 public:
  ObjectListModel(const SensorPreset& preset, std::uint64_t seed);
  [[nodiscard]] SensorDescription description() const override;
  [[nodiscard]] double hz() const override { return preset_.hz; }
  void observe(const Scene& scene, std::vector<Measurement>& measurements) override;

 private:
  struct Track {
    std::int64_t id;
    double heading_sigma;  ///< [rad] this track's own, from the preset's range
    Wander x;              ///< [m]
    Wander y;              ///< in units of the sigma at its distance
    Wander heading;        ///< in units of heading_sigma
    bool seen_by_camera = false;
    Time last_seen{};
  };

  ObjectListPreset preset_;
  RadarPreset radar_;
  CameraBoxesPreset camera_;
  double noise_;  ///< its errors are so many times as large as it states
  Random random_;
  double misalignment_;  ///< [rad]
  std::int64_t next_id_ = 1;
  std::map<std::int64_t, Track>
      tracks_;  ///< by the vehicle's id; ordered, as every order must be the same twice

  Track make_track();
  void advance_tracks(Time now);
  void verify(Track& track, const Pose2& ego_from_vehicle);
  TrackedObject describe(const Track& track, const SceneVehicle& vehicle, const Pose2& ego_from_vehicle);
};

}  // namespace lanefuse
