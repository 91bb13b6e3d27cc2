// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/evaluate_highlights.hpp"

#include <algorithm>

namespace lanefuse {

Highlights::Highlights(Time begin, Time end) {
  for (const double share : {0.1, 0.5, 0.9}) {
    due_.push_back(begin + from_seconds(share * to_seconds(end - begin)));
  }
}

void Highlights::add(const LaneRecord& record, const std::function<void(LaneRecord&)>& complete) {
  const Time time = record.estimate.time;
  if (!first_) first_ = time;
  const double seconds = to_seconds(time - *first_);
  if (taken_ < due_.size() && time >= due_[taken_]) {
    while (taken_ < due_.size() && time >= due_[taken_]) ++taken_;
    spread_.push_back({record, seconds, false});
    complete(spread_.back().record);
  }
  const auto off = std::count_if(record.debug.switches.begin(), record.debug.switches.end(),
                                 [](const SwitchState& s) { return s.value < 0.5; });
  if (off <= most_switched_count_) return;
  most_switched_count_ = off;
  most_switched_ = Highlight{record, seconds, true};
  complete(most_switched_->record);
}

std::vector<Highlight> Highlights::chosen() const {
  std::vector<Highlight> all = spread_;
  if (most_switched_) all.push_back(*most_switched_);
  std::stable_sort(all.begin(), all.end(),
                   [](const Highlight& a, const Highlight& b) { return a.seconds < b.seconds; });
  // Of two that are one cycle the first came from the spread: what the other knows is passed on.
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].seconds == all[i + 1].seconds) all[i].most_switched = true;
  }
  const auto same = [](const Highlight& a, const Highlight& b) { return a.seconds == b.seconds; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

}  // namespace lanefuse
