// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "camera/image.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

struct LaneSegmentationConfig {
  std::string model;      ///< an .onnx file
  int input_width = 0;    ///< [px] that images are scaled to; 0: as they are
  int input_height = 0;   ///< [px]
  double input_mean = 0;  ///< of every channel: the network sees (level - mean) * scale
  double input_scale = 1.0 / 255;
  bool red_first = true;     ///< the channels' order
  bool logits = false;       ///< a single channel holds logits, else probabilities
  int background_class = 0;  ///< of several channels; all others are paint
  double threshold = 0.5;    ///< probability from which a pixel of a single channel is paint
  double width_max = 0.6;    ///< [m] wider runs are no marking
  double range_max = 80;     ///< [m] features further ahead are dropped
  double spacing = 1;        ///< [m] between features of one line
  double sigma_px = 2;       ///< [px] of the image: how well the network places the middle of the paint
  double confidence = 0.7;   ///< of each feature
};

/// The user's own lane-segmentation network: which pixels of an image are paint.
///
/// Takes any ONNX network with one image as its input, 1 x 3 x H x W, and one mask as its (first) output:
/// 1 x 1 x h x w with the probability of paint, or 1 x N x h x w with a score for each class. It runs on the
/// processor; the same image gives the same bytes.
class LaneSegmentation {
 public:
  /// Throws a configuration Error that names the model where its file is missing or is no network that OpenCV
  /// can load.
  explicit LaneSegmentation(const LaneSegmentationConfig& config);
  ~LaneSegmentation();
  LaneSegmentation(LaneSegmentation&&) noexcept;
  LaneSegmentation& operator=(LaneSegmentation&&) noexcept;
  LaneSegmentation(const LaneSegmentation&) = delete;
  LaneSegmentation& operator=(const LaneSegmentation&) = delete;

  /// Runs of paint in the mask's rows, from top to bottom, in pixels of the image. Throws a configuration
  /// Error where the network cannot take the image, or its output is no mask.
  std::vector<ImageBar> find(const ImageView& image);

 private:
  struct Network;
  LaneSegmentationConfig config_;
  std::unique_ptr<Network> network_;
};

}  // namespace lanefuse
