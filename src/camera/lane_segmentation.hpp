// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "camera/ground_projection.hpp"
#include "camera/image.hpp"
#include "core/feature.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

struct LaneSegmentationConfig {
  std::string model;             ///< ONNX file; empty: none
  int input_width = 0;           ///< [px] of the network's input; 0: the image's
  int input_height = 0;          ///< [px]
  double scale = 1.0 / 255;      ///< the network sees (pixel - mean) * scale
  double mean = 0;               ///< in levels of 255, of every channel
  bool swap_red_blue = true;     ///< the network wants red, green, blue
  int background_class = 0;      ///< of an output with several channels: everything else is paint
  bool is_probability = true;    ///< a single channel holds probabilities; false: logits
  double threshold = 0.5;        ///< probability from which a pixel is paint
  int row_step = 2;              ///< [px] of the mask between the rows that are looked at
  double width_max = 0.6;        ///< [m] a run that is wider is no marking
  double range_max = 80;         ///< [m] features further ahead are dropped
  double sigma_px = 2;           ///< [px] of the image: how well the network places the middle of the paint
  double confidence = 0.7;       ///< of each feature
};

/// The user's own lane-segmentation network: which pixels of an image are paint.
///
/// Takes any ONNX network with one image as its input, 1 x 3 x H x W, and one mask as its (first) output:
/// 1 x 1 x h x w with the probability of paint, or 1 x N x h x w with a score for each class. Runs on the
/// processor, through OpenCV, on one thread: the same image gives the same bytes.
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

  /// Runs of paint in the mask's rows, in pixels of the image. Throws a configuration Error where the network
  /// cannot take the image, or its output is no mask.
  std::vector<ImageBar> find(const ImageView& image);

 private:
  struct Network;
  LaneSegmentationConfig config_;
  std::unique_ptr<Network> network_;
};

/// Marking features of what a network found: each run's middle on the road, its heading along the run above
/// and below it, its covariance from the pixel's and the camera's pose. Bars that became features are marked
/// as believed.
std::vector<Feature> features_of_runs(std::vector<ImageBar>& bars, const GroundProjection& projection,
                                      const LaneSegmentationConfig& config);

}  // namespace lanefuse
