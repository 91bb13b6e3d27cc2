// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/sensor_trust.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanefuse {
namespace {

/// Looks of two sensors that are this near in time tell of the same moment.
constexpr double kSameMoment = 0.12;  // [s]

bool same_sightings(const SightingSet& a, const SightingSet& b) {
  return std::equal(a.sightings.begin(), a.sightings.end(), b.sightings.begin(), b.sightings.end(),
                    [](const Sighting& p, const Sighting& q) {
                      return p.range == q.range && p.bearing == q.bearing && p.range_rate == q.range_rate;
                    });
}

}  // namespace

const char* to_string(SensorFault fault) {
  switch (fault) {
    case SensorFault::none:
      return "none";
    case SensorFault::frozen:
      return "frozen";
    case SensorFault::mirrored:
      return "mirrored";
    case SensorFault::range_rates:
      return "range_rates";
    case SensorFault::beyond_field:
      return "beyond_field";
    case SensorFault::turned:
      return "turned";
    case SensorFault::blind:
      return "blind";
  }
  return "unknown";
}

bool SensorTrust::believe(const SightingSet& look, std::size_t turned_beyond) {
  const std::size_t place = place_of(look);
  Sensor& sensor = sensors_[place];
  const double seconds = to_seconds(look.measured_at - sensor.last.measured_at);
  if (seconds > 0) {
    if (look.velocity.norm() > config_.min_speed) {
      forget(sensor, seconds);
      count_repeats(sensor, look);
      vote_on_field(look, turned_beyond, sensor.field);
      vote_on_standing(look, sensor.standing);
      vote_on_standing_mirror(look, sensor.standing_mirror);
      sensor.chains.look(look, seconds);
      sensor.things.look(look);
      compare_with_others(sensor, look);
      count_blindness(sensor, look, seconds);
      sensor.last = look;
      conclude(place, look.measured_at);
    } else {
      // Standing, nothing is learned: neither that it is frozen nor that it is sound again.
      sensor.repeats = 0;
      sensor.sight = {};
      sensor.unsound = look.measured_at;
      sensor.last = look;
    }
  }
  return sensor.fault == SensorFault::none;
}

std::size_t SensorTrust::place_of(const SightingSet& look) {
  const auto at =
      std::lower_bound(sensors_.begin(), sensors_.end(), look.sensor_id,
                       [](const Sensor& sensor, std::uint32_t id) { return sensor.last.sensor_id < id; });
  const std::ptrdiff_t place = at - sensors_.begin();
  if (at == sensors_.end() || at->last.sensor_id != look.sensor_id) {
    Sensor fresh;
    fresh.last.sensor_id = look.sensor_id;
    // A first look is compared with nothing.
    fresh.last.measured_at = look.measured_at - Duration(1);
    sensors_.insert(at, std::move(fresh));
  }
  return static_cast<std::size_t>(place);
}

void SensorTrust::forget(Sensor& sensor, double seconds) const {
  const double keep = std::exp(-seconds / config_.memory_s);
  sensor.field.forget(keep);
  sensor.standing.forget(keep);
  sensor.standing_mirror.forget(keep);
  sensor.chains.forget(keep);
  sensor.sight.forget(std::exp(-seconds / config_.proof_memory_s));
  sensor.things.forget(std::exp(-seconds / config_.proof_memory_s));
  for (Word& word : sensor.words) {
    word.votes.forget(keep);
    word.offsets.forget(std::exp(-seconds / config_.proof_memory_s));
  }
}

void SensorTrust::count_repeats(Sensor& sensor, const SightingSet& look) const {
  const bool again = !look.sightings.empty() && same_sightings(look, sensor.last);
  sensor.repeats = again ? sensor.repeats + 1 : 0;
}

void SensorTrust::compare_with_others(Sensor& sensor, const SightingSet& look) {
  for (const Sensor& other : sensors_) {
    if (&other == &sensor) continue;
    if (std::abs(to_seconds(look.measured_at - other.last.measured_at)) > kSameMoment) continue;
    auto word = std::find_if(sensor.words.begin(), sensor.words.end(),
                             [&](const Word& w) { return w.from == other.last.sensor_id; });
    if (word == sensor.words.end()) {
      word = sensor.words.insert(sensor.words.end(), Word{other.last.sensor_id, {}, {}});
    }
    vote_on_mirror(look, other.last, word->votes);
    if (look.kind == SightingKind::camera && other.last.kind == SightingKind::radar)
      compare_bearings(look, other.last, word->offsets);
  }
  const bool disputed = std::any_of(sensor.words.begin(), sensor.words.end(), [&](const Word& word) {
    return word.votes.say_wrong(config_.enough / 2, config_.ratio);
  });
  // What it proved before may have been before it broke.
  if (disputed && !sensor.disputed) sensor.things.clear();
  sensor.disputed = disputed;
}

void SensorTrust::count_blindness(Sensor& sensor, const SightingSet& look, double seconds) const {
  if (!look.sightings.empty()) {
    sensor.sight = {};
    return;
  }
  constexpr double kLongest = 0.2;  // [s] that one look stands for
  const bool vehicles = look.field.detection > 0 && look.field.detection_far > 0 &&
                        std::any_of(sensors_.begin(), sensors_.end(), [&](const Sensor& other) {
                          const double apart = to_seconds(look.measured_at - other.last.measured_at);
                          return &other != &sensor && std::abs(apart) < kSameMoment &&
                                 other.fault == SensorFault::none && should_see(look, other.last);
                        });
  (vehicles ? sensor.sight.wrong : sensor.sight.sound) += std::min(seconds, kLongest);
}

/// Whether the word of others, leaving one of them aside, is against this sensor.
bool SensorTrust::is_contradicted(std::size_t place, std::uint32_t but_for) const {
  FaultVotes sum;
  for (const Word& word : sensors_[place].words) {
    if (word.from == but_for || fault_of(word.from) != SensorFault::none) continue;
    sum.sound += word.votes.sound;
    sum.wrong += word.votes.wrong;
  }
  return sum.wrong > sum.sound;
}

/// Whether things that stand have proven that it looks where the rig says that it does.
bool SensorTrust::is_proven(const Sensor& sensor) const {
  const bool side = sensor.standing_mirror.say_sound(config_.enough, config_.ratio) ||
                    sensor.things.mirror().say_sound(config_.proof, config_.ratio);
  return side && sensor.things.turn().straight(config_.enough);
}

bool SensorTrust::is_mirrored(std::size_t place) const {
  const bool camera = sensors_[place].last.kind == SightingKind::camera;
  FaultVotes sum;
  int accusers = 0;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const std::uint32_t id = sensors_[i].last.sensor_id;
    const auto& words = sensors_[place].words;
    const auto word = std::find_if(words.begin(), words.end(), [&](const Word& w) { return w.from == id; });
    if (word == words.end() || sensors_[i].fault != SensorFault::none) continue;
    if (is_contradicted(i, sensors_[place].last.sensor_id)) continue;
    sum.sound += word->votes.sound;
    sum.wrong += word->votes.wrong;
    if (word->votes.wrong > config_.ratio * word->votes.sound) accusers += is_proven(sensors_[i]) ? 2 : 1;
  }
  const int needed = camera || is_proven(sensors_[place]) ? 2 : 1;
  return accusers >= needed && sum.say_wrong(config_.enough, config_.ratio);
}

/// A radar by what stands, a camera by the bearings of a radar that is proven.
bool SensorTrust::is_turned(const Sensor& sensor) const {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto turned = [&](const BearingOffsets& offsets) {
    return offsets.turned(config_.pairs, config_.ratio, config_.turned_deg * kDegree).has_value();
  };
  if (sensor.last.kind == SightingKind::radar) return turned(sensor.things.turn());
  return std::any_of(sensor.words.begin(), sensor.words.end(), [&](const Word& word) {
    const auto from = std::find_if(sensors_.begin(), sensors_.end(),
                                   [&](const Sensor& s) { return s.last.sensor_id == word.from; });
    return from->fault == SensorFault::none && from->things.turn().straight(config_.pairs) &&
           turned(word.offsets);
  });
}

SensorFault SensorTrust::verdict(std::size_t place) const {
  const Sensor& sensor = sensors_[place];
  const int repeats = sensor.last.sightings.size() > 1 ? config_.repeats : config_.repeats_single;
  if (sensor.repeats >= repeats) return SensorFault::frozen;
  if (sensor.field.say_wrong(config_.enough, 1)) return SensorFault::beyond_field;
  if (sensor.standing.say_wrong(config_.enough, config_.ratio) || sensor.chains.say_wrong()) {
    return SensorFault::range_rates;
  }
  const bool mirrored = sensor.standing_mirror.say_wrong(config_.enough, config_.ratio) ||
                        sensor.things.mirror().say_wrong(config_.proof, config_.ratio) || is_mirrored(place);
  if (mirrored) return SensorFault::mirrored;
  if (is_turned(sensor)) return SensorFault::turned;
  return sensor.sight.say_wrong(config_.blind_s, config_.ratio) ? SensorFault::blind : SensorFault::none;
}

/// That nothing speaks against it any more is not enough: something must speak for it.
bool SensorTrust::is_sound_again(const Sensor& sensor) const {
  const auto sound = [&](const FaultVotes& votes) { return votes.say_sound(config_.enough, config_.ratio); };
  switch (sensor.fault) {
    case SensorFault::range_rates:
      return sound(sensor.standing) || sensor.chains.say_sound();
    case SensorFault::mirrored:
      return sound(sensor.standing_mirror) ||
             std::any_of(sensor.words.begin(), sensor.words.end(),
                         [&](const Word& word) { return sound(word.votes); });
    case SensorFault::beyond_field:
      return sound(sensor.field);
    case SensorFault::turned:
      return sensor.things.turn().straight(config_.pairs) ||
             std::any_of(sensor.words.begin(), sensor.words.end(),
                         [&](const Word& word) { return word.offsets.straight(config_.pairs); });
    default:
      return sensor.repeats == 0 && !sensor.last.sightings.empty();
  }
}

void SensorTrust::conclude(std::size_t place, Time now) {
  Sensor& sensor = sensors_[place];
  const SensorFault found = verdict(place);
  if (found != SensorFault::none) sensor.fault = found;
  if (found != SensorFault::none || !is_sound_again(sensor)) sensor.unsound = now;
  // Named only for want of a proof, which is there now.
  const bool cleared = sensor.fault == SensorFault::mirrored && found == SensorFault::none &&
                       sensor.disputed && is_proven(sensor);
  if (cleared || to_seconds(now - sensor.unsound) > config_.recover_s) sensor.fault = SensorFault::none;
  distrusted_.clear();
  for (const Sensor& known : sensors_) {
    if (known.fault != SensorFault::none) distrusted_.push_back(known.last.sensor_id);
  }
}

SensorFault SensorTrust::fault_of(std::uint32_t sensor_id) const {
  for (const Sensor& sensor : sensors_) {
    if (sensor.last.sensor_id == sensor_id) return sensor.fault;
  }
  return SensorFault::none;
}

void SensorTrust::reset() {
  sensors_.clear();
  distrusted_.clear();
}

}  // namespace lanefuse
