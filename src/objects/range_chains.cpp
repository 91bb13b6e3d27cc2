// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/range_chains.hpp"

#include <cmath>
#include <utility>

#include "objects/fault_votes.hpp"

namespace lanefuse {
namespace {

constexpr double kEnough = 60;     ///< [m^2] of promised change: reflections wander by a metre
constexpr double kWrongBy = 0.45;  ///< of the ratio: far more than reflections' wander explains
constexpr double kSoundWithin = 0.3;

}  // namespace

void RangeChains::look(const SightingSet& look, double seconds) {
  constexpr double kLength = 0.5;   // [s] of a chain that is compared
  constexpr double kLongest = 0.3;  // [s] between two looks
  constexpr double kStands = 3;     // [m/s] what stands is likely to be taken for its neighbour
  next_.clear();
  for (const Sighting& sighting : look.sightings) {
    const auto speed = ground_speed(look, sighting);
    if (!speed || std::abs(*speed) < kStands) continue;
    Chain chain{sighting, 0, sighting.range, 0};
    const Chain* known = seconds < kLongest ? before(sighting, seconds) : nullptr;
    if (known) {
      chain = *known;
      chain.promised += (known->last.range_rate.value_or(0) + *sighting.range_rate) / 2 * seconds;
      chain.seconds += seconds;
      chain.last = sighting;
    }
    if (chain.seconds > kLength) {
      promised_squared_ += chain.promised * chain.promised;
      product_ += chain.promised * (sighting.range - chain.begin);
      chain = {sighting, 0, sighting.range, 0};
    }
    next_.push_back(chain);
  }
  std::swap(chains_, next_);
}

/// The nearest to where it would have come from, by its own word.
const RangeChains::Chain* RangeChains::before(const Sighting& sighting, double seconds) const {
  constexpr double kAcross = 1.5;     // [m]
  constexpr double kRangeRate = 1.5;  // [m/s]
  double nearest = 2;                 // [m]
  const Chain* found = nullptr;
  for (const Chain& chain : chains_) {
    const double rate = *sighting.range_rate;
    const double apart = std::abs(sighting.range - rate * seconds - chain.last.range);
    const double across = std::abs(sighting.bearing - chain.last.bearing) * sighting.range;
    if (std::abs(rate - *chain.last.range_rate) > kRangeRate || across > kAcross || apart > nearest) continue;
    nearest = apart;
    found = &chain;
  }
  return found;
}

void RangeChains::forget(double keep) {
  promised_squared_ *= keep;
  product_ *= keep;
}

bool RangeChains::is_certain() const { return promised_squared_ > kEnough; }
bool RangeChains::say_wrong() const { return is_certain() && std::abs(ratio() - 1) > kWrongBy; }
bool RangeChains::say_sound() const { return is_certain() && std::abs(ratio() - 1) < kSoundWithin; }

}  // namespace lanefuse
