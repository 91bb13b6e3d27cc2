// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lane_estimate.hpp"

namespace lanefuse {

/// Describes each lane from its two boundaries: range, confidence, and the points of its middle. Lanes whose
/// boundaries are missing, or speak nowhere in common, have no middle.
///
/// Estimators say how sure they are of each boundary, not of both together. What the two share (the road's
/// course, the car's heading) moves both the same way, so their correlation is taken to lie between 0 and 1,
/// and each sigma is the largest there can then be: of the middle the mean of both (correlation 1), of the
/// width the root of the sum of squares (correlation 0).
///
/// Allocates nothing where the lanes' vectors have been as long before.
void describe_lanes(LaneEstimate& estimate);

}  // namespace lanefuse
