// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "road/road_estimator.hpp"

namespace lanefuse {

const LaneEstimate& RoadEstimator::process(const Cycle& cycle) {
  estimate_.time = cycle.time;
  return estimate_;
}

void RoadEstimator::reset() {
  estimate_ = {};
  debug_ = {};
}

}  // namespace lanefuse
