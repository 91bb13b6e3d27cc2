// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/feature.hpp"

namespace lanefuse {

/// The ego lane's width as the serial camera sees it, for the features of other vehicles [IROS16, sec. II-E4:
/// "w is taken from the SMC clothoids if available"]. A slow average: a lane's width changes over hundreds of
/// metres, the measured one in every frame.
class LaneWidthFilter {
 public:
  void update(const FeatureSet& set);
  /// Nothing before the camera has seen both markings, nor later than `max_age` after it last did.
  [[nodiscard]] std::optional<LaneWidth> width(Time now, Duration max_age = std::chrono::seconds(5)) const;
  void reset() { width_.reset(); }

 private:
  std::optional<LaneWidth> width_;
  Time last_seen_{};
};

}  // namespace lanefuse
