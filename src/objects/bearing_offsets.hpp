// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace lanefuse {

/// By how much bearings seem to be too large, as a slowly forgetting histogram: what is right piles up in one
/// place, and what was put together by mistake lies anywhere.
class BearingOffsets {
 public:
  void add(double offset);  ///< [rad]; those beyond kReach do not count
  void forget(double keep);

  /// [rad] The offset that most speak for, where they are `enough`, it is `turned` [rad] or more, and `ratio`
  /// times as many as speak for none at all.
  [[nodiscard]] std::optional<double> turned(double enough, double ratio, double turned) const;
  /// That most speak for none.
  [[nodiscard]] bool straight(double enough) const;

  static constexpr double kReach = 14.5;  ///< [deg] to either side

 private:
  static constexpr std::size_t kBins = 29;  ///< a degree each
  std::array<double, kBins> counts_{};

  /// Of a bin and its neighbours.
  [[nodiscard]] double around(std::size_t bin) const;
  [[nodiscard]] std::size_t peak() const;
};

}  // namespace lanefuse
