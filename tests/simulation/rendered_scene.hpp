// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "simulation/camera_image_model.hpp"
#include "simulation/image_truth.hpp"
#include "simulation/scene_run.hpp"

namespace lanefuse::testing {

/// A moment on a road to take pictures of.
class RenderedScene {
 public:
  explicit RenderedScene(std::uint64_t seed, RoadKind kind = RoadKind::gentle) : run_(seed, kind) {
    for (int tick = 0; tick < 50; ++tick) run_.advance();
    scene_ = run_.scene();
    Random random(seed, "attitude of the test");
    constexpr double kDegree = std::numbers::pi / 180;
    mounting_ = {0,
                 0,
                 1.25 + random.normal(0.01),
                 random.normal(0.3 * kDegree),
                 random.normal(0.4 * kDegree),
                 random.normal(0.4 * kDegree)};
  }
  RenderedScene(const RenderedScene&) = delete;
  RenderedScene& operator=(const RenderedScene&) = delete;

  [[nodiscard]] Scene& scene() { return scene_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] Mounting& mounting() { return mounting_; }
  [[nodiscard]] const Mounting& mounting() const { return mounting_; }

 private:
  SceneRun run_;
  Scene scene_;
  Mounting mounting_;
};

/// As clean as it gets: new paint on one grey, as bright in the corners, and no noise.
inline RenderConfig clean_picture() {
  RenderConfig config;
  config.wear = 0;
  config.texture = 0;
  config.vignetting = 0;
  config.noise = false;
  return config;
}

inline int green(const Image& image, int u, int v) { return image.view().row(v)[3 * u + 1]; }

inline bool same_pixels(const Image& a, const Image& b) {
  const auto size = static_cast<std::size_t>(a.width()) * a.height() * a.channels();
  return a.width() == b.width() && a.height() == b.height() &&
         std::memcmp(a.view().data, b.view().data, size) == 0;
}

}  // namespace lanefuse::testing
