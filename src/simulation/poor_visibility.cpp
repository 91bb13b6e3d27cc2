// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/poor_visibility.hpp"

#include <algorithm>
#include <iterator>

namespace lanefuse {

void PoorVisibility::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  Scene seen = scene;
  const double way = scene.ego.station - start_;
  const bool always = disturbance_.kind == Disturbance::Kind::short_range;
  if (always || recurs_at(way, disturbance_.first, disturbance_.every, disturbance_.length)) {
    seen.visibility = std::min(scene.visibility, disturbance_.visibility);
  }
  std::vector<Measurement> measured = observe_undisturbed(seen);
  std::move(measured.begin(), measured.end(), std::back_inserter(measurements));
}

}  // namespace lanefuse
