// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/radar_codec.hpp"

#include "lanefuse/measurements.pb.h"
#include "recording/message_bytes.hpp"

namespace lanefuse {

mcap::Bytes encode_radar_scan(const RadarScan& scan) {
  v1::RadarScan message;
  for (const RadarDetection& detection : scan.detections) {
    v1::RadarDetection& part = *message.add_detections();
    part.set_range(detection.range);
    part.set_bearing(detection.bearing);
    part.set_range_rate(detection.range_rate);
    if (detection.address) part.set_address(*detection.address);
    part.set_new_track(detection.new_track);
  }
  return to_bytes(message);
}

RadarScan decode_radar_scan(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<v1::RadarScan>(bytes);
  check_count(message.detections_size(), kMaxFeatures, message.GetTypeName());
  RadarScan scan{.stamp = stamp, .detections = {}};
  for (const v1::RadarDetection& part : message.detections()) {
    RadarDetection& detection = scan.detections.emplace_back();
    detection.range = part.range();
    detection.bearing = part.bearing();
    detection.range_rate = part.range_rate();
    if (part.has_address()) detection.address = part.address();
    detection.new_track = part.new_track();
  }
  return scan;
}

}  // namespace lanefuse
