// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "camera/image.hpp"
#include "sensors/camera_intrinsics.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// How the network of a user wants its images and writes its boxes.
struct OnnxVehicleDetectorConfig {
  std::filesystem::path model;     ///< an .onnx file
  int input_width = 640;           ///< [px] that images are scaled to
  int input_height = 640;          ///< [px]
  double input_scale = 1.0 / 255;  ///< pixels are multiplied by it
  bool red_first = true;           ///< the channels' order
  bool has_objectness = false;     ///< a fifth number before the classes' scores, multiplied with them
  bool transposed = false;         ///< the output is [(4 + scores) x N] instead of [N x (4 + scores)]
  std::vector<int> vehicle_classes = {2, 5, 7};  ///< columns of the scores that are vehicles; COCO's
  double least_score = 0.4;                      ///< in [0, 1]
  double most_overlap = 0.5;                     ///< of two boxes (IoU); the weaker goes
};

/// Any object detector that a user brings as an ONNX network whose rows are (cx, cy, width, height in input
/// pixels, scores...), as the YOLO family writes them.
class OnnxVehicleDetector {
 public:
  /// Throws a configuration Error that names the model where it cannot be read.
  OnnxVehicleDetector(const CameraIntrinsics& intrinsics, OnnxVehicleDetectorConfig config);
  ~OnnxVehicleDetector();
  OnnxVehicleDetector(OnnxVehicleDetector&&) noexcept;
  OnnxVehicleDetector& operator=(OnnxVehicleDetector&&) noexcept;

  /// The vehicles in this image, the nearest first; distances by where the boxes stand on the road. Throws a
  /// configuration Error where the network's output has not the shape that the configuration says.
  [[nodiscard]] std::vector<VehicleBox> detect(const ImageView& image, const CameraPose& pose);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lanefuse
