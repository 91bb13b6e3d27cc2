// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

#include "core/random.hpp"
#include "simulation/radar_view.hpp"

namespace lanefuse {

/// Where on a vehicle a radar's waves come back from: a point of a face that it sees, the larger the face
/// looks the likelier. On rear and front it scatters about a centre that wanders slowly, so that no mean over
/// a second finds the middle; on the sides it is anywhere, now and then a wheel or the nearest corner.
class VehicleReflections {
 public:
  explicit VehicleReflections(Random random) : random_(random) {}

  /// Seen from `radar`, a point in the world. `now` must not go back.
  Reflection draw(const SceneVehicle& vehicle, const Eigen::Vector2d& radar, Time now);

 private:
  struct Centre {
    Wander wander;  ///< in half widths
    Time seen{};
  };
  Random random_;
  std::map<std::int64_t, Centre> centres_;  ///< by the vehicle's id

  double across(const SceneVehicle& vehicle, Time now);
  Eigen::Vector2d on_side(const SceneVehicle& vehicle, const Eigen::Vector2d& radar);
};

}  // namespace lanefuse
