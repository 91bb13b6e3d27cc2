// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/late_messages.hpp"

#include <algorithm>
#include <variant>

namespace lanefuse {

void LateMessages::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  for (Measurement& measurement : observe_undisturbed(scene)) {
    const bool late = random_.chance(delays_.share);
    const double delay = random_.uniform(delays_.at_least, delays_.at_most);
    const auto postpone = [&](auto& message) {
      Stamp& stamp = message.stamp;
      if (late) stamp.received_at += from_seconds(delay);
      stamp.received_at = std::max(stamp.received_at, stamp.measured_at + from_seconds(delays_.in_all));
    };
    std::visit(postpone, measurement);
    measurements.push_back(std::move(measurement));
  }
}

}  // namespace lanefuse
