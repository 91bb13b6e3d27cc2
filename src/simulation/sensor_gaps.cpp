// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/sensor_gaps.hpp"

#include <iterator>

namespace lanefuse {

void SensorGaps::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  if (!start_) start_ = scene.time;
  std::vector<Measurement> measured = observe_undisturbed(scene);
  if (recurs_at(to_seconds(scene.time - *start_), gaps_.first, gaps_.every, gaps_.length)) return;
  std::move(measured.begin(), measured.end(), std::back_inserter(measurements));
}

}  // namespace lanefuse
