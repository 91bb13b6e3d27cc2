// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sources/feature_source.hpp"

namespace lanefuse {

struct SerialCameraConfig {
  bool enabled = true;
  double marking_width = 0.15;      ///< [m] of the paint, where the camera does not measure it
  double covariance_inflation = 1;  ///< factor on the clothoids' covariance
};

/// The serial camera's tracked ego lane [IROS16, secs. II-B, II-E2]. Its clothoids follow the inner edges of
/// the paint; here they move outward by half its width, to the centre line that all of Lanefuse means by a
/// boundary.
class SerialCameraSource final : public FeatureSource {
 public:
  explicit SerialCameraSource(const SerialCameraConfig& config) : config_(config) {}
  InputAccounting add(const Measurement& measurement, const SourceContext& context) override;
  void collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) override;
  void reset() override { pending_.clear(); }

 private:
  bool take(ClothoidMeasurement clothoid, Side side, double usual_width, FeatureSet& set) const;

  SerialCameraConfig config_;
  std::vector<FeatureSet> pending_;
};

}  // namespace lanefuse
