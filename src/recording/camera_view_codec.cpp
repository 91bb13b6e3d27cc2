// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/camera_view_codec.hpp"

#include "lanefuse/camera_view.pb.h"
#include "recording/core_fields.hpp"
#include "recording/message_bytes.hpp"
#include "recording/mounting_fields.hpp"

namespace lanefuse {
namespace {

constexpr int kMaxParts = 65'536;  ///< windows or bars of one image

void put(const CameraPose& pose, v1::CameraPose& message) {
  lanefuse::put(pose.mounting, *message.mutable_mounting());
  message.set_vertical_curvature(pose.vertical_curvature);
  put_covariance(pose.covariance, *message.mutable_covariance());
  message.set_vertical_curvature_sigma(pose.vertical_curvature_sigma);
}

CameraPose take(const v1::CameraPose& message) {
  CameraPose pose;
  pose.mounting = lanefuse::take(message.mounting());
  pose.vertical_curvature = finite(message.vertical_curvature(), message.GetTypeName());
  pose.covariance = take_covariance<4>(message.covariance(), message.GetTypeName());
  pose.vertical_curvature_sigma = finite(message.vertical_curvature_sigma(), message.GetTypeName());
  return pose;
}

void put(const VehicleBox& box, v1::VehicleBox& message) {
  message.set_left(box.left);
  message.set_top(box.top);
  message.set_right(box.right);
  message.set_bottom(box.bottom);
  message.set_distance(box.distance);
  message.set_lateral(box.lateral);
  message.set_width(box.width);
  message.set_confidence(box.confidence);
}

VehicleBox take(const v1::VehicleBox& message) {
  return {message.left(),     message.top(),     message.right(), message.bottom(),
          message.distance(), message.lateral(), message.width(), message.confidence()};
}

void put(const SearchWindow& window, v1::SearchWindow& message) {
  message.set_row(window.row);
  message.set_left(window.left);
  message.set_right(window.right);
  message.set_side(static_cast<v1::Side>(window.side));
  message.set_found(window.found);
  message.set_column(window.column);
}

SearchWindow take(const v1::SearchWindow& message) {
  if (!v1::Side_IsValid(message.side())) refuse(message.GetTypeName(), "its side is unknown");
  return {message.row(),   message.left(),  message.right(), static_cast<Side>(message.side()),
          message.found(), message.column()};
}

void put(const ImageBar& bar, v1::ImageBar& message) {
  message.set_row(bar.row);
  message.set_left(bar.left);
  message.set_right(bar.right);
  message.set_believed(bar.believed);
}

ImageBar take(const v1::ImageBar& message) {
  return {message.row(), message.left(), message.right(), message.believed()};
}

template <class Part, class Message>
void put_all(const std::vector<Part>& parts, google::protobuf::RepeatedPtrField<Message>& messages) {
  for (const Part& part : parts) put(part, *messages.Add());
}

template <class Part, class Message>
void take_all(const google::protobuf::RepeatedPtrField<Message>& messages, std::vector<Part>& parts) {
  check_count(messages.size(), kMaxParts, v1::CameraView::descriptor()->full_name());
  for (const Message& message : messages) parts.push_back(take(message));
}

}  // namespace

mcap::Bytes encode_camera_view(const CameraView& view) {
  v1::CameraView message;
  message.set_sensor_id(view.sensor_id);
  message.set_measured_at(to_nanoseconds(view.measured_at));
  message.set_fault(static_cast<v1::CameraView::Fault>(view.fault));
  message.set_calibration(static_cast<v1::CameraView::Calibration>(view.calibration));
  put(view.pose, *message.mutable_pose());
  put_all(view.vehicles, *message.mutable_vehicles());
  put_all(view.windows, *message.mutable_windows());
  put_all(view.bars, *message.mutable_bars());
  return to_bytes(message);
}

CameraView decode_camera_view(std::span<const std::byte> bytes) {
  const auto message = parsed<v1::CameraView>(bytes);
  if (!v1::CameraView::Fault_IsValid(message.fault()) ||
      !v1::CameraView::Calibration_IsValid(message.calibration())) {
    refuse(message.GetTypeName(), "its fault or calibration is unknown");
  }
  CameraView view;
  view.sensor_id = message.sensor_id();
  view.measured_at = from_nanoseconds(message.measured_at());
  view.fault = static_cast<ImageFault>(message.fault());
  view.calibration = static_cast<CalibrationStatus>(message.calibration());
  view.pose = take(message.pose());
  take_all(message.vehicles(), view.vehicles);
  take_all(message.windows(), view.windows);
  take_all(message.bars(), view.bars);
  return view;
}

}  // namespace lanefuse
