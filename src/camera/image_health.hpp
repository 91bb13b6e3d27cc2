// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "camera/image.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

struct ImageHealthConfig {
  int dark = 25;                 ///< an image whose brightest hundredth is below this shows nothing
  int glaring = 245;             ///< four fifths of the lower half above this: nothing is seen on the road
  int blank_rows = 16;           ///< of one colour at the lower end: the rest was never received
  double blank_share = 0.25;     ///< the same for black and white ones: night and glare do that, too
  double frozen_distance = 0.3;  ///< [m] driven, after which the same bytes are a frozen picture
};

/// Judges the images of one camera, in their order: whether they can be believed.
class ImageHealth {
 public:
  explicit ImageHealth(const ImageHealthConfig& config = {}) : config_(config) {}

  /// `decoded` is what decode_image() made of the image's bytes, `camera` the lens that they should come
  /// from, `distance_moved` [m] how far the car drove since the image judged before.
  ImageFault judge(const CameraImage& image, const std::optional<Image>& decoded,
                   const CameraIntrinsics& camera, double distance_moved);

  void reset();

 private:
  [[nodiscard]] bool is_frozen(const CameraImage& image, double distance_moved);

  ImageHealthConfig config_;
  std::vector<std::byte> last_bytes_;
  double moved_since_ = 0;  ///< [m] driven since the picture was a new one
};

}  // namespace lanefuse
