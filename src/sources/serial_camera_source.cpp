// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/serial_camera_source.hpp"

#include <iterator>

namespace lanefuse {

bool SerialCameraSource::take(ClothoidMeasurement clothoid, Side side, double usual_width,
                              FeatureSet& set) const {
  clothoid.side = side;
  if (!is_plausible(clothoid)) return false;
  const double outward = clothoid.marking_width.value_or(usual_width) / 2;
  clothoid.clothoid.lateral_offset += side == Side::left ? outward : -outward;
  clothoid.covariance *= config_.covariance_inflation;
  set.clothoids.push_back(clothoid);
  return true;
}

InputAccounting SerialCameraSource::add(const Measurement& measurement, const SourceContext&) {
  const auto* lane = std::get_if<SerialLane>(&measurement);
  if (!lane) return {};
  FeatureSet set;
  set.source = Source::serial_camera;
  set.sensor_id = lane->stamp.sensor_id;
  set.measured_at = lane->stamp.measured_at;
  const double width = lane->marking_width.value_or(config_.marking_width);
  InputAccounting accounting;
  if (lane->left) ++(take(*lane->left, Side::left, width, set) ? accounting.used : accounting.rejected);
  if (lane->right) ++(take(*lane->right, Side::right, width, set) ? accounting.used : accounting.rejected);
  if (!set.clothoids.empty()) pending_.push_back(std::move(set));
  return accounting;
}

void SerialCameraSource::collect(Time, const SourceContext&, std::vector<FeatureSet>& sets) {
  std::move(pending_.begin(), pending_.end(), std::back_inserter(sets));
  pending_.clear();
}

}  // namespace lanefuse
