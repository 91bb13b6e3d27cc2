// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/camera_boxes_codec.hpp"

#include "lanefuse/measurements.pb.h"
#include "recording/message_bytes.hpp"

namespace lanefuse {

mcap::Bytes encode_camera_boxes(const CameraBoxes& boxes) {
  v1::CameraBoxes message;
  for (const BoxDetection& box : boxes.boxes) {
    v1::BoxDetection& part = *message.add_boxes();
    part.set_left(box.left);
    part.set_top(box.top);
    part.set_right(box.right);
    part.set_bottom(box.bottom);
    part.set_confidence(box.confidence);
  }
  return to_bytes(message);
}

CameraBoxes decode_camera_boxes(std::span<const std::byte> bytes, const Stamp& stamp) {
  const auto message = parsed<v1::CameraBoxes>(bytes);
  check_count(message.boxes_size(), kMaxObjects, message.GetTypeName());
  CameraBoxes boxes{.stamp = stamp, .boxes = {}};
  for (const v1::BoxDetection& part : message.boxes()) {
    boxes.boxes.push_back({part.left(), part.top(), part.right(), part.bottom(), part.confidence()});
  }
  return boxes;
}

}  // namespace lanefuse
