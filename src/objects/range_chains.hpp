// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "objects/sighting.hpp"

namespace lanefuse {

/// Follows moving things through one radar's looks, and compares how their ranges change with what their
/// range rates add up to: the same, unless these are in some other unit.
class RangeChains {
 public:
  /// `seconds` since the look before.
  void look(const SightingSet& look, double seconds);
  void forget(double keep);

  /// Metres of change for each that the range rates promised.
  [[nodiscard]] double ratio() const { return promised_squared_ > 0 ? product_ / promised_squared_ : 1; }
  /// Whether enough has been seen to say so.
  [[nodiscard]] bool is_certain() const;
  [[nodiscard]] bool say_wrong() const;
  [[nodiscard]] bool say_sound() const;

 private:
  struct Chain {
    Sighting last;
    double seconds = 0;
    double begin = 0;     ///< [m] range where it began
    double promised = 0;  ///< [m] that the range rates add up to since
  };
  std::vector<Chain> chains_;
  std::vector<Chain> next_;
  double promised_squared_ = 0;  ///< [m^2]
  double product_ = 0;           ///< [m^2]

  [[nodiscard]] const Chain* before(const Sighting& sighting, double seconds) const;
};

}  // namespace lanefuse
