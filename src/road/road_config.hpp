// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace lanefuse {

/// By what measurements are given to lines: by the gates of the filter, or by the labels of a simulation. The
/// latter is the oracle of a benchmark, and nothing that drives could have it.
enum class RoadAssociation : std::uint8_t { gated = 0, labelled = 1 };

/// Settings of the road-level estimator. Measured in docs/road.md.
struct RoadConfig {
  RoadAssociation association = RoadAssociation::gated;
  double sigma_max = 2;  ///< [m] a boundary speaks as far as its lateral sigma is below this
};

}  // namespace lanefuse
