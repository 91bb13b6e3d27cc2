// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sources/feature_source.hpp"

namespace lanefuse {

struct HighResolutionCameraConfig {
  bool enabled = true;
  double range_max = 130;  ///< [m] [IROS16, sec. II-B]
};

/// Marking features of the high-resolution camera, taken as they are [IROS16, sec. II-E3].
class HighResolutionCameraSource final : public FeatureSource {
 public:
  explicit HighResolutionCameraSource(const HighResolutionCameraConfig& config) : config_(config) {}
  InputAccounting add(const Measurement& measurement, const SourceContext& context) override;
  void collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) override;
  void reset() override { pending_.clear(); }

 private:
  HighResolutionCameraConfig config_;
  std::vector<FeatureSet> pending_;
};

}  // namespace lanefuse
