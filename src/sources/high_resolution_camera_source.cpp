// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/high_resolution_camera_source.hpp"

#include <iterator>

namespace lanefuse {

InputAccounting HighResolutionCameraSource::add(const Measurement& measurement, const SourceContext&) {
  const auto* markings = std::get_if<MarkingFeatures>(&measurement);
  if (!markings) return {};
  FeatureSet set;
  set.source = Source::high_resolution_camera;
  set.sensor_id = markings->stamp.sensor_id;
  set.measured_at = markings->stamp.measured_at;
  set.shared_error = markings->shared_error;
  InputAccounting accounting;
  for (Feature feature : markings->features) {
    if (!is_plausible(feature)) {
      ++accounting.rejected;
    } else if (feature.x > config_.range_max) {
      ++accounting.dropped;
    } else {
      feature.source = Source::high_resolution_camera;
      // A painted bar is no witness with two sides.
      feature.track_id = kNoTrack;
      feature.side = Side::none;
      set.features.push_back(feature);
      ++accounting.used;
    }
  }
  if (!set.features.empty()) pending_.push_back(std::move(set));
  return accounting;
}

void HighResolutionCameraSource::collect(Time, const SourceContext&, std::vector<FeatureSet>& sets) {
  std::move(pending_.begin(), pending_.end(), std::back_inserter(sets));
  pending_.clear();
}

}  // namespace lanefuse
