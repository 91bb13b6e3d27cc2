// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "objects/bearing_offsets.hpp"
#include "objects/fault_votes.hpp"
#include "objects/sighting.hpp"

namespace lanefuse {

/// What a radar proves of its own mounting: things that stand pass by as the car moves and turns, and do so
/// in one way only where bearings are what they are said to be. A mirror image turns against the car, and
/// seen askew, things do not come from where the car drives to.
class StandingThings {
 public:
  /// A look of a radar; others have no range rates that tell what stands.
  void look(const SightingSet& look);
  void forget(double keep);
  /// Begins to gather anew.
  void clear();

  /// Of as it is said, against mirrored. Nothing comes of it while the car drives straight on.
  [[nodiscard]] const FaultVotes& mirror() const { return mirror_; }
  /// By how much bearings are too large.
  [[nodiscard]] const BearingOffsets& turn() const { return turn_; }

 private:
  struct Thing {
    Time seen_at{};
    Pose2 odometry_from_sensor;
    Sighting sighting;
  };
  std::vector<Thing> things_;
  std::vector<Thing> fresh_;
  FaultVotes mirror_;
  BearingOffsets turn_;

  void follow(const SightingSet& look, const Sighting& sighting);
  void compare(const SightingSet& look, const Sighting& sighting, const Thing& thing);
};

}  // namespace lanefuse
