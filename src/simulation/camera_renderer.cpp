// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>
#include <vector>

#include "simulation/ground_rays.hpp"
#include "simulation/image_row.hpp"

namespace lanefuse {
namespace {

/// Renders the rows from `first` up to `last`: a window of three rows of light moves down.
void render_rows(const ImageScene& scene, const CameraChip& chip, std::pair<int, int> rows, Image& image) {
  const auto width = static_cast<std::size_t>(image.width());
  std::vector<LinearColour> above(width + 2), here(width + 2), below(width + 2);
  ImageRowPainter painter(scene);
  const auto paint = [&](int v, std::vector<LinearColour>& row) {
    painter.paint(std::clamp(v, 0, image.height() - 1), &row[1]);
    row.front() = row[1];
    row.back() = row[width];
  };
  paint(rows.first - 1, above);
  paint(rows.first, here);
  const auto key = static_cast<std::uint64_t>(to_nanoseconds(scene.time()));
  for (int v = rows.first; v < rows.second; ++v) {
    paint(v + 1, below);
    chip.expose({above.data(), here.data(), below.data()}, v, key, image.row(v));
    above.swap(here);
    here.swap(below);
  }
}

}  // namespace

CameraRenderer::CameraRenderer(const CameraIntrinsics& camera, const RenderConfig& config)
    : camera_(camera),
      ends_(camera_),
      config_(config),
      light_(image_light(config.conditions)),
      textures_(std::make_shared<const SurfaceTextures>(config.seed)),
      chip_({camera, light_, config.blur_px, config.vignetting, config.noise, config.seed}) {}

Image CameraRenderer::render(const Scene& scene, const Mounting& mounting) const {
  const CameraIntrinsics& camera = camera_.intrinsics();
  Image image(camera.width, camera.height, 3);
  const ImageScene prepared({scene, camera_, ends_, mounting}, config_, light_, *textures_);
  // The rows near the horizon cost most, so every thread takes many small bands, in turn.
  const int threads = std::max(1, config_.threads);
  constexpr int kBand = 64;
  const auto work = [&](int thread) {
    for (int first = thread * kBand; first < camera.height; first += threads * kBand) {
      render_rows(prepared, chip_, {first, std::min(first + kBand, camera.height)}, image);
    }
  };
  std::vector<std::thread> others;
  for (int thread = 1; thread < threads; ++thread) others.emplace_back(work, thread);
  work(0);
  for (std::thread& other : others) other.join();
  return image;
}

}  // namespace lanefuse
