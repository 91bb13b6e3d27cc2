// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sources/feature_source.hpp"

namespace lanefuse {

struct EgoPathConfig {
  bool enabled = false;           ///< the paper does not use it
  double driver_sigma = 0.3;      ///< [m] of the driver about the middle of the lane
  double driver_heading_deg = 1;  ///< [deg]
  double confidence = 0.35;       ///< c_m
  double min_speed = 3;           ///< [m/s] slower, the car may be anywhere
  LaneWidth default_width;        ///< where no camera measures the lane
};

/// The car itself as a witness of its lane: what is said of other vehicles [IROS16, sec. II-E4] holds for it,
/// too, and its own place is known without a sensor. Not in the paper; meant for drives without a camera,
/// where no one else tells which lane the car is in.
class EgoPathSource final : public FeatureSource {
 public:
  explicit EgoPathSource(const EgoPathConfig& config) : config_(config) {}
  InputAccounting add(const Measurement&, const SourceContext&) override { return {}; }
  void collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) override;
  void reset() override {}

 private:
  EgoPathConfig config_;
};

}  // namespace lanefuse
