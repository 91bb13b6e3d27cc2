// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/lane_estimate.hpp"
#include "evaluation/lane_roles.hpp"
#include "evaluation/line_ahead.hpp"

namespace lanefuse {

/// What one cycle's estimate shows that is not there.
struct FalseCounts {
  std::uint64_t boundaries = 0;
  std::uint64_t lanes = 0;
};

/// Judged 20 m ahead, or as near to that as the boundary or lane reaches; not where no true lane is known
/// there. A boundary is false that is more than 1 m from every true one. A lane is false whose centre lies in
/// no true lane, or that has a true boundary inside, more than 1 m from both of its edges. `lines` are the
/// road's boundaries around the car.
FalseCounts count_false(const LaneEstimate& estimate, const TrueLanes& lanes,
                        const std::vector<LineAhead>& lines);

/// Whether the edges of the estimated ego lane are, beside the car, nearer to other true boundaries than to
/// those of the true ego lane.
bool in_wrong_lane(const EstimatedRoles& estimated, const TrueRoles& truth, const TrueLanes& lanes,
                   const std::vector<LineAhead>& lines);

}  // namespace lanefuse
