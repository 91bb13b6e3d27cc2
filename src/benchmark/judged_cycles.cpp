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
    return cycle.first.time > frames_.back().time;
  });
  std::for_each(waiting_.begin(), first_to_wait, [this](const Cycle& cycle) { judge(cycle); });
  waiting_.erase(waiting_.begin(), first_to_wait);
  forget_frames();
}

EvaluationResult JudgedCycles::finish() {
  for (const Cycle& cycle : waiting_) judge(cycle);
  waiting_.clear();
  return evaluation_.result();
}

void JudgedCycles::judge(const Cycle& cycle) {
  const auto& [estimate, serial_camera] = cycle;
  const auto frame = frame_at(frames_, estimate.time);
  frame ? evaluation_.add(estimate, *frame, &serial_camera) : evaluation_.add_without_truth(estimate);
}

void JudgedCycles::forget_frames() {
  // Estimates come later than their time: by cycles, never by as much as this.
  constexpr std::size_t kKept = 128;
  if (frames_.size() >= 2 * kKept) frames_.erase(frames_.begin(), frames_.end() - kKept);
}

}  // namespace lanefuse
