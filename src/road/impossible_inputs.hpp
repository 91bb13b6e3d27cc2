// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/feature.hpp"

namespace lanefuse {

/// Sorts out what no sensor can have meant: numbers that are none, places that nothing reaches, covariances
/// that are none. A filter never forgets: one of them would spoil it for good.
class ImpossibleInputs {
 public:
  /// The set without what is impossible; valid until the next call, and as long as `set` is.
  const FeatureSet& sort_out(const FeatureSet& set);

  /// How many items of the last set were impossible.
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  FeatureSet sound_;
  std::uint64_t count_ = 0;
};

}  // namespace lanefuse
