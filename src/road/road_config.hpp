// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lanefuse {

/// Settings of the road-level estimator. Measured in docs/road.md.
struct RoadConfig {
  double sigma_max = 2;  ///< [m] a boundary speaks as far as its lateral sigma is below this
};

}  // namespace lanefuse
