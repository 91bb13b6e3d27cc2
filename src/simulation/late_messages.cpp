// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/late_messages.hpp"

#include <variant>

namespace lanefuse {

void LateMessages::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  for (Measurement& measurement : observe_undisturbed(scene)) {
    const bool late = random_.chance(delays_.share);
    const double delay = random_.uniform(delays_.at_least, delays_.at_most);
    if (late) {
      std::visit([delay](auto& message) { message.stamp.received_at += from_seconds(delay); }, measurement);
    }
    measurements.push_back(std::move(measurement));
  }
}

}  // namespace lanefuse
