// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/time.hpp"
#include "objects/fault_votes.hpp"
#include "objects/range_chains.hpp"
#include "objects/sighting.hpp"
#include "objects/standing_things.hpp"

namespace lanefuse {

enum class SensorFault : std::uint8_t {
  none = 0,
  frozen = 1,        ///< the same sightings again and again while the car moves
  mirrored = 2,      ///< what it says is left, the others see to the right
  range_rates = 3,   ///< they do not fit how its ranges change, or the own speed: km/h for m/s
  beyond_field = 4,  ///< bearings that it cannot see: degrees for radians
  turned = 5,        ///< mounted at another angle than the rig says, by degrees
  blind = 6,         ///< empty looks where the others see vehicles well inside its field
};
const char* to_string(SensorFault fault);

struct SensorTrustConfig {
  double min_speed = 3;    ///< [m/s] of the own car: slower, nothing is judged
  double memory_s = 1;     ///< [s] over which evidence is forgotten: what was sound must not speak for long
  double enough = 8;       ///< votes before anything is said
  double ratio = 3;        ///< times as many must say one thing as the other
  double recover_s = 2;    ///< [s] for which a distrusted sensor must be sound again
  int repeats = 2;         ///< of a look with several sightings: frozen
  int repeats_single = 3;  ///< of a look with one: coarse radars repeat a steady leader now and then
  double proof_memory_s = 6;  ///< [s] over which is forgotten what standing things and pairs of bearings tell
  double proof = 12;          ///< votes of standing things before they prove on which side they are
  double pairs = 14;          ///< that must agree before a sensor is said to be turned
  double turned_deg = 4;      ///< [deg] off before a sensor is said to be turned
  double blind_s = 2;         ///< [s] with vehicles and without a word before a sensor is said to be blind
};

/// Finds the sensors that cannot be believed, from what they say alone: against their own earlier looks, the
/// own speed, their field, and what the other sensors say of the same places. Where one sensor's word stands
/// against another's, a radar whose standing things prove its own mounting is right, and the word of a sensor
/// that is contradicted by a third does not count. Where nothing is proven, nobody can tell which is right:
/// the radar is left out, since no vehicle is verified without both, until the road's next bend proves one of
/// them.
class SensorTrust {
 public:
  explicit SensorTrust(const SensorTrustConfig& config) : config_(config) {}

  /// Whether this look may be used. `turned_beyond` counts detections whose bearings were beyond half a turn:
  /// they are no sightings any more, but tell of degrees. Looks that come late are not judged.
  bool believe(const SightingSet& look, std::size_t turned_beyond);

  /// The ids of the sensors that are left out, in ascending order; valid until the next call.
  [[nodiscard]] std::span<const std::uint32_t> distrusted() const { return distrusted_; }
  [[nodiscard]] SensorFault fault_of(std::uint32_t sensor_id) const;

  void reset();

 private:
  /// What one sensor says of another.
  struct Word {
    std::uint32_t from = 0;
    FaultVotes votes;
    BearingOffsets offsets;  ///< of a camera's bearings against these
  };
  struct Sensor {
    SightingSet last;
    int repeats = 0;
    FaultVotes field;
    FaultVotes standing;         ///< things that stand: their range rates in m/s, or in km/h
    FaultVotes standing_mirror;  ///< the same seen to the other side
    RangeChains chains;
    StandingThings things;
    FaultVotes sight;       ///< [s] with something in its looks, or with nothing though others see vehicles
    bool disputed = false;  ///< whether another sees on the other side what it sees
    std::vector<Word> words;
    SensorFault fault = SensorFault::none;
    Time unsound{};  ///< when it was found wrong last, or not yet right
  };

  const SensorTrustConfig config_;
  std::vector<Sensor> sensors_;  ///< in order of their ids
  std::vector<std::uint32_t> distrusted_;

  std::size_t place_of(const SightingSet& look);
  void forget(Sensor& sensor, double seconds) const;
  void count_repeats(Sensor& sensor, const SightingSet& look) const;
  void compare_with_others(Sensor& sensor, const SightingSet& look);
  [[nodiscard]] bool is_contradicted(std::size_t place, std::uint32_t but_for) const;
  void count_blindness(Sensor& sensor, const SightingSet& look, double seconds) const;
  [[nodiscard]] bool is_proven(const Sensor& sensor) const;
  [[nodiscard]] bool is_mirrored(std::size_t place) const;
  [[nodiscard]] bool is_turned(const Sensor& sensor) const;
  [[nodiscard]] SensorFault verdict(std::size_t place) const;
  [[nodiscard]] bool is_sound_again(const Sensor& sensor) const;
  void conclude(std::size_t place, Time now);
};

}  // namespace lanefuse
