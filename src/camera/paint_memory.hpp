// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "core/feature.hpp"

namespace lanefuse {

/// What is known about the paint of one marking from looking at it for a while: solid or dashed, its colour
/// and its width.
class PaintMemory {
 public:
  void forget() { *this = {}; }
  /// The car has driven `way` [m]: what was ahead is nearer now.
  void move(double way);
  /// Whether paint was found `distance` [m] ahead.
  void look(double distance, bool found);
  /// A bar of the marking: its colour, and its width [m] where it was seen sharply.
  void note(bool yellow, std::optional<double> width);

  [[nodiscard]] MarkingEvidence evidence() const;
  /// [m]
  [[nodiscard]] std::optional<double> width() const;
  /// The painted part of the road that was looked at, in [0, 1]; nothing while too little was seen.
  [[nodiscard]] std::optional<double> painted() const;

 private:
  static constexpr int kAhead = 40;  ///< [m]
  static constexpr int kBins = 120;  ///< of one metre, the rest behind the car
  struct Stretch {
    float looks = 0;
    float hits = 0;
  };

  std::array<Stretch, kBins> stretches_{};  ///< a ring; newest_ is the one farthest ahead
  int newest_ = 0;
  double rest_ = 0;  ///< [m] driven since the ring was turned
  double yellow_ = 0.5;
  double width_ = 0.12;
  double seen_ = 0;
  double width_seen_ = 0;
};

}  // namespace lanefuse
