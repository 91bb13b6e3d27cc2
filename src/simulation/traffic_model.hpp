// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scene.hpp"

namespace lanefuse {

inline constexpr std::int64_t kEgoId = 0;

/// The ego car and the vehicles around it, wherever their motion comes from: the built-in drivers, a
/// recording, another simulator.
class TrafficModel {
 public:
  virtual ~TrafficModel() = default;

  virtual void advance(double seconds) = 0;
  /// Where everyone is now, which is `time`. The ego car's id is kEgoId.
  [[nodiscard]] virtual Scene scene(Time time) const = 0;
};

}  // namespace lanefuse
