// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/measurement_codec.hpp"

#include "recording/camera_boxes_codec.hpp"
#include "recording/camera_codec.hpp"
#include "recording/gnss_ins_codec.hpp"
#include "recording/image_codec.hpp"
#include "recording/motion_codec.hpp"
#include "recording/object_codec.hpp"
#include "recording/radar_codec.hpp"
#include "recording/topics.hpp"

namespace lanefuse {
namespace {

using Messages = std::vector<EncodedMeasurement>;

struct Encoder {
  Messages operator()(const VehicleMotion& motion) const {
    Messages messages;
    const bool only_wheels = motion.wheel_speeds && !motion.speed && !motion.yaw_rate;
    if (!only_wheels) messages.push_back({topic::kVehicleMotion, encode_motion(motion)});
    if (motion.wheel_speeds) messages.push_back({topic::kWheelSpeeds, encode_wheel_speeds(motion)});
    return messages;
  }
  Messages operator()(const SerialLane& lane) const {
    return {{topic::kSerialCamera, encode_serial_lane(lane)}};
  }
  Messages operator()(const MarkingFeatures& markings) const {
    return {{topic::kHighResolutionCamera, encode_marking_features(markings)}};
  }
  Messages operator()(const RadarScan& scan) const { return {{topic::kRadar, encode_radar_scan(scan)}}; }
  Messages operator()(const ObjectList& list) const { return {{topic::kObjects, encode_objects(list)}}; }
  Messages operator()(const GnssInsFix& fix) const { return {{topic::kGnssIns, encode_gnss_ins(fix)}}; }
  Messages operator()(const CameraImage& image) const {
    return {{topic::kImage, encode_camera_image(image)}};
  }
  Messages operator()(const CameraBoxes& boxes) const {
    return {{topic::kCameraBoxes, encode_camera_boxes(boxes)}};
  }
};

template <auto decode>
Measurement decoded(std::span<const std::byte> bytes, const Stamp& stamp) {
  return decode(bytes, stamp);
}

}  // namespace

std::vector<EncodedMeasurement> encode(const Measurement& measurement) {
  return std::visit(Encoder{}, measurement);
}

MeasurementDecoder decoder_of(std::string_view topic) {
  if (topic == topic::kVehicleMotion) return &decoded<decode_motion>;
  if (topic == topic::kWheelSpeeds) return &decoded<decode_wheel_speeds>;
  if (topic == topic::kSerialCamera) return &decoded<decode_serial_lane>;
  if (topic == topic::kHighResolutionCamera) return &decoded<decode_marking_features>;
  if (topic == topic::kRadar) return &decoded<decode_radar_scan>;
  if (topic == topic::kObjects) return &decoded<decode_objects>;
  if (topic == topic::kGnssIns) return &decoded<decode_gnss_ins>;
  if (topic == topic::kCameraBoxes) return &decoded<decode_camera_boxes>;
  if (topic == topic::kImage) return &decoded<decode_camera_image>;
  return nullptr;
}

}  // namespace lanefuse
