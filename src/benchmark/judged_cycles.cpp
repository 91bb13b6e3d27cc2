// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/judged_cycles.hpp"

#include <algorithm>

#include "evaluation/true_frames.hpp"

namespace lanefuse {

void JudgedCycles::add(const std::vector<TrueFrame>& frames) {
  if (frames.empty()) return;
  frames_.insert(frames_.end(), frames.begin(), frames.end());
  const auto first_to_wait = std::find_if(waiting_.begin(), waiting_.end(), [this](const Cycle& cycle) {
    return cycle.estimate.time > frames_.back().time;
  });
  std::for_each(waiting_.begin(), first_to_wait, [this](const Cycle& cycle) { judge(cycle); });
  waiting_.erase(waiting_.begin(), first_to_wait);
  forget_frames();
}

EvaluationResult JudgedCycles::finish() {
  for (const Cycle& cycle : waiting_) judge(cycle);
  waiting_.clear();
  EvaluationResult result = evaluation_.result();
  if (TrackingFigures tracking = tracking_.figures(); tracking.judged())
    result.tracking = std::move(tracking);
  return result;
}

void JudgedCycles::judge(const Cycle& cycle) {
  const auto frame = frame_at(frames_, cycle.estimate.time);
  if (!frame) return evaluation_.add_without_truth(cycle.estimate);
  evaluation_.add(cycle.estimate, *frame, &cycle.serial_camera);
  tracking_.add(*frame, cycle.objects);
}

void JudgedCycles::forget_frames() {
  // Estimates come later than their time: by cycles, never by as much as this.
  constexpr std::size_t kKept = 128;
  if (frames_.size() >= 2 * kKept) frames_.erase(frames_.begin(), frames_.end() - kKept);
}

}  // namespace lanefuse
