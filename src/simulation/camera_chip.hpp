// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "camera/image.hpp"
#include "core/time.hpp"
#include "sensors/camera_intrinsics.hpp"
#include "simulation/image_light.hpp"

namespace lanefuse {

/// From the light of a scene to the bytes of an image: the lens's blur and vignetting, exposure, shot and
/// read noise, and the tone curve of a display (gamma 2.2).
class CameraChip {
 public:
  struct Setup {
    CameraIntrinsics camera;
    ImageLight light;
    double blur_px = 0.6;      ///< [px]
    double vignetting = 0.28;  ///< of the light that is lost in a corner
    bool noise = true;
    std::uint64_t seed = 1;
  };
  explicit CameraChip(const Setup& setup);

  /// Three rows of light, of which the image row `v` is the middle one; each has one more pixel before its
  /// first and after its last.
  struct Rows {
    const LinearColour* above = nullptr;
    const LinearColour* here = nullptr;
    const LinearColour* below = nullptr;
  };
  /// `noise_key` names the image among those of the drive.
  void expose(const Rows& rows, int v, std::uint64_t noise_key, std::uint8_t* bytes) const;

 private:
  static constexpr int kTones = 2048;
  static constexpr int kNoiseCount = 1 << 13;

  Setup setup_;
  float beside_;                     ///< weight of either neighbour in the blur
  std::vector<LinearColour> noise_;  ///< rows begin anywhere in its first kNoiseCount
  std::array<std::uint8_t, kTones + 1> tones_{};
};

}  // namespace lanefuse
