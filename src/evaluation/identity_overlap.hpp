// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <utility>

namespace lanefuse {

/// In how many frames each track was on each vehicle, over a whole drive: what IDF1 is made of.
class IdentityOverlap {
 public:
  /// A vehicle, or a track on it, from one time out of sight to the next.
  struct Visit {
    std::int64_t id = 0;
    std::int64_t number = 0;
    auto operator<=>(const Visit&) const = default;
  };

  /// One frame in which this track was on this vehicle.
  void add(const Visit& vehicle, const Visit& track) { ++frames_[{vehicle, track}]; }

  /// The most frames that can be right if each vehicle is given one track, and no track two vehicles.
  [[nodiscard]] std::uint64_t id_hits() const;

 private:
  std::map<std::pair<Visit, Visit>, std::uint64_t> frames_;
};

}  // namespace lanefuse
