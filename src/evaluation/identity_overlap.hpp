// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <utility>

namespace lanefuse {

/// In how many frames each track was on each vehicle, over a whole drive: what IDF1 is made of.
class IdentityOverlap {
 public:
  /// One frame in which this track was on this vehicle.
  void add(std::int64_t vehicle, std::int64_t track) { ++frames_[{vehicle, track}]; }

  /// The most frames that can be right if each vehicle is given one track, and no track two vehicles.
  [[nodiscard]] std::uint64_t id_hits() const;

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint64_t> frames_;
};

}  // namespace lanefuse
