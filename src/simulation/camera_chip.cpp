// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_chip.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace lanefuse {
namespace {

std::uint64_t mixed(std::uint64_t key) {
  key = (key ^ (key >> 31)) * 0x9fb21c651e98df25ULL;
  return key ^ (key >> 29);
}

}  // namespace

CameraChip::CameraChip(const Setup& setup) : setup_(setup) {
  const double shoulder = setup.blur_px > 0 ? std::exp(-1 / (2 * setup.blur_px * setup.blur_px)) : 0;
  beside_ = static_cast<float>(shoulder / (1 + 2 * shoulder));
  Random random(setup.seed, "noise of a chip");
  const double sigma = setup.noise ? setup.light.noise : 0;
  noise_.resize(kNoiseCount + static_cast<std::size_t>(setup.camera.width));
  for (LinearColour& noise : noise_) {
    for (int i = 0; i < 3; ++i) noise[i] = static_cast<float>(random.normal(sigma));
    noise[3] = 0;
  }
  for (int i = 0; i <= kTones; ++i) {
    const double root = static_cast<double>(i) / kTones;
    tones_[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(255 * std::pow(root, 2 / 2.2)));
  }
}

/// Shot noise is the same everywhere in the root of the light, which is where noise is added; so is half of
/// the tone curve.
void CameraChip::expose(const Rows& rows, int v, std::uint64_t noise_key, std::uint8_t* bytes) const {
  const CameraIntrinsics& camera = setup_.camera;
  const float middle = 1 - 2 * beside_;
  const LinearColour glare = setup_.light.glare * setup_.light.horizon;
  const auto lost = static_cast<float>(setup_.vignetting);
  const double corner = std::hypot(camera.width, camera.height) / 2;
  const auto per_corner = static_cast<float>(1 / corner);
  const auto half_width = static_cast<float>(camera.width / 2.0);
  const auto dv = static_cast<float>((v - camera.height / 2.0) / corner);
  const std::uint64_t key = mixed(noise_key + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(v + 1));
  const LinearColour* const noise = &noise_[key % kNoiseCount];
  const auto column = [&](int i) {
    return LinearColour(middle * rows.here[i] + beside_ * (rows.above[i] + rows.below[i]));
  };
  LinearColour left = column(0);
  LinearColour centre = column(1);
  for (int u = 0; u < camera.width; ++u) {
    const LinearColour right = column(u + 2);
    const LinearColour light = middle * centre + beside_ * (left + right);
    left = centre;
    centre = right;
    const float du = (static_cast<float>(u) - half_width) * per_corner;
    const float kept = setup_.light.exposure * (1 - lost * (du * du + dv * dv));
    const LinearColour root = ((light + glare) * kept).max(0.0F).sqrt() + noise[u];
    const Eigen::Array4i tone = (root.max(0.0F).min(1.0F) * static_cast<float>(kTones) + 0.5F).cast<int>();
    for (int i = 0; i < 3; ++i) bytes[3 * u + i] = tones_[static_cast<std::size_t>(tone[i])];
  }
}

}  // namespace lanefuse
