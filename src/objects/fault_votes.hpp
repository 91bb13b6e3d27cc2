// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "objects/bearing_offsets.hpp"
#include "objects/sighting.hpp"

namespace lanefuse {

/// Slowly forgetting counts of what speaks for a sensor and what against it.
struct FaultVotes {
  double sound = 0;
  double wrong = 0;

  void forget(double keep) {
    sound *= keep;
    wrong *= keep;
  }
  [[nodiscard]] bool say_wrong(double enough, double ratio) const {
    return wrong >= enough && wrong > ratio * sound;
  }
  [[nodiscard]] bool say_sound(double enough, double ratio) const {
    return sound >= enough && sound > ratio * wrong;
  }
};

/// [m/s] The speed over ground that a radar's sighting has along its line of sight; none of a camera's.
std::optional<double> ground_speed(const SightingSet& look, const Sighting& sighting);

/// [rad] By how much a radar's bearing is too large, if what it sees stands: how fast that comes nearer tells
/// where it is, beside the car's way but not ahead and abeam. Nothing where no angle fits within reason.
std::optional<double> turn_by_range_rate(const SightingSet& look, const Sighting& sighting);

/// Bearings within the sensor's field, or beyond it by far.
void vote_on_field(const SightingSet& look, std::size_t turned_beyond, FaultVotes& votes);

/// Whether things that stand have the range rates that our own speed gives them, or these times 3.6.
void vote_on_standing(const SightingSet& look, FaultVotes& votes);

/// Whether things that stand do so where the sensor says, or on the other side of its axis: sensors that look
/// aside see them under range rates that tell.
void vote_on_standing_mirror(const SightingSet& look, FaultVotes& votes);

/// Whether what `other` sees in this look's field is seen in this look, too, or is seen where the mirror of
/// the look's x axis would put it.
void vote_on_mirror(const SightingSet& look, const SightingSet& other, FaultVotes& votes);

/// By how much the look's bearings are larger than those of `other` for things as far away that move, each
/// with each: of all pairs only those that belong together agree.
void compare_bearings(const SightingSet& look, const SightingSet& other, BearingOffsets& offsets);

/// Whether `other` sees something that moves where this look's sensor cannot but see it: ahead of both, near
/// enough, and between the edges of the field.
bool should_see(const SightingSet& look, const SightingSet& other);

}  // namespace lanefuse
