// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "objects/sighting.hpp"

namespace lanefuse {

/// Where guard rails and walls run beside us, from what radars see standing along the road: a line of things
/// that goes on for many metres, not a car that stands there. Vehicles of our direction do not drive beyond
/// it; what seems to is a mirror image.
class BarrierWatch {
 public:
  /// Takes in what stands in this look; `seconds` since the one before.
  void look(const SightingSet& look, double seconds);

  /// [m] across our own course to the nearest line of standing things to the left and right (a negative
  /// number); very far where none is known.
  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double right() const { return right_; }

 private:
  static constexpr double kBin = 0.5;    ///< [m] across
  static constexpr int kBins = 50;       ///< to either side
  static constexpr double kStation = 3;  ///< [m] along
  static constexpr double kFar = 1e3;    ///< [m]

  /// For each bin across the stations along in which something stood: a bit each, of the station modulo 64.
  std::array<std::uint64_t, 2 * kBins + 1> stood_{};
  double way_ = 0;  ///< [m] driven
  double left_ = kFar;
  double right_ = -kFar;

  void forget(std::int64_t from, std::int64_t to);
  void find_lines();
  [[nodiscard]] bool is_line(int bin) const;
};

}  // namespace lanefuse
