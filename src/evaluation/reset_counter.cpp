// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/reset_counter.hpp"

namespace lanefuse {

void ResetCounter::add(const LaneEstimate& estimate) {
  if (last_status_ == EstimateStatus::ok && estimate.status == EstimateStatus::invalid) {
    ++count_;
    last_edges_.reset();
  }
  last_status_ = estimate.status;
  const Lane* ego = ego_lane(estimate);
  if (!ego) return;
  const Edges now{ego->left_boundary, ego->right_boundary};
  if (last_edges_) {
    const auto known = [this](std::uint64_t id) {
      return id == last_edges_->left || id == last_edges_->right;
    };
    if (!known(now.left) && !known(now.right)) ++count_;
  }
  last_edges_ = now;
}

}  // namespace lanefuse
