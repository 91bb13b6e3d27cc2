// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "simulation/guard_rails.hpp"
#include "simulation/line_of_sight.hpp"
#include "simulation/radar_view.hpp"

namespace lanefuse {

/// Ghosts: vehicles that a radar sees mirrored in the guard rail beside them. The same vehicle's mirror stays
/// for seconds, scan by scan, so that a radar alone takes it for a vehicle beyond the rail.
class RailMirrors {
 public:
  /// `a_scan`: how many are seen in a scan, at least and at most, as far as there are any.
  RailMirrors(const Range& a_scan, std::shared_ptr<const GuardRails> rails, Random random);

  /// The mirrored vehicles that this scan sees; `sight` is the radar's.
  std::vector<SceneVehicle> observe(const Scene& scene, const RadarView& view, const LineOfSight& sight);

 private:
  struct Mirror {
    std::int64_t vehicle;
    Time until;
    SceneVehicle image;
  };
  int fewest_;
  int most_;
  std::shared_ptr<const GuardRails> rails_;
  Random random_;
  std::vector<Mirror> mirrors_;  ///< the oldest first

  [[nodiscard]] std::optional<SceneVehicle> image_of(const Scene& scene, const SceneVehicle& vehicle) const;
  void renew(const Scene& scene, const RadarView& view);
  void add(const Scene& scene, const RadarView& view);
};

}  // namespace lanefuse
