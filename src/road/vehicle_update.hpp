// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/feature.hpp"
#include "core/time.hpp"
#include "road/road_state.hpp"

namespace lanefuse {

/// Takes in where other vehicles drive. Each has its own way of being beside the middle of its lane, which
/// stays for seconds: what moves it slowly is the road's course, what moves it fast is its own. A vehicle
/// that goes from one lane to the next says nothing of the road until it has settled: the switch of [IROS16,
/// sec. II-E4] for a state.
class VehicleUpdate {
 public:
  explicit VehicleUpdate(const RoadConfig& config) : config_(config) {}

  /// A vehicle's middle, put together from the features to its left and right.
  struct Sighting {
    std::int64_t track_id = kNoTrack;
    Eigen::Vector2d middle;
    double range = 0;     ///< [m] in the frame of the measurement
    double variance = 0;  ///< across, of the track alone
    double heading = 0;   ///< [rad]
    double heading_variance = 0;
    bool changing_lane = false;
    LineLabel left = kNoLabel;
    LineLabel right = kNoLabel;
  };

  std::size_t take(const FeatureSet& set, const Pose2& now_from_measured, RoadState& state);

  /// Of the last set: where vehicles were that are in no lane that is known.
  [[nodiscard]] std::span<const Sighting> strays() const { return strays_; }

 private:
  /// Lines of a lane, or one line twice.
  struct Reference {
    std::size_t left = 0;
    std::size_t right = 0;
    bool in_lane = false;
  };
  std::optional<Reference> reference_of(const Sighting& sighting, const RoadAxis::Foot& foot,
                                        const RoadState& state);
  static std::vector<RoadVehicle>::const_iterator find(std::int64_t track_id, const RoadState& state);
  static void forget(std::int64_t track_id, RoadState& state);
  RoadVehicle* vehicle_of(const Sighting& sighting, const Reference& reference, double aside, Time now,
                          RoadState& state) const;
  void take_headings(double seconds, RoadState& state) const;
  void gather(const FeatureSet& set, const Pose2& now_from_measured);
  bool take_one(const Sighting& sighting, Time now, RoadState& state);

  RoadConfig config_;
  std::optional<RoadState> before_frame_;  ///< only where not from near to far
  std::vector<Sighting> sightings_;
  std::vector<Sighting> strays_;
  std::optional<Time> taken_at_;
};

}  // namespace lanefuse
