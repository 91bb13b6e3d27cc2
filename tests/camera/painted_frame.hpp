// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "camera/ground_projection.hpp"
#include "camera/image.hpp"
#include "core/clothoid.hpp"
#include "core/random.hpp"

namespace lanefuse::testing {

/// A line of paint beside the road's course.
struct PaintedLine {
  double lateral = 0;  ///< [m]
  double width = 0.15;
  double dash = 0;  ///< [m] of paint; 0 for a solid line
  double gap = 0;
  double phase = 0;        ///< [m]
  double brightness = 60;  ///< [grey levels] over the road's
  bool yellow = false;
};

/// A plain road as a camera sees it: asphalt with noise, and paint whose share of every pixel is exact.
struct PaintedRoad {
  Clothoid course;
  std::vector<PaintedLine> lines;
  double asphalt = 90;
  double noise = 3;
  double blur_px = 0.7;

  [[nodiscard]] double y(const PaintedLine& line, double x) const { return course.y(x) + line.lateral; }
  [[nodiscard]] static bool painted(const PaintedLine& line, double x) {
    if (line.dash <= 0) return true;
    const double period = line.dash + line.gap;
    const double at = x - line.phase;
    return at - period * std::floor(at / period) < line.dash;
  }
};

/// Three lanes, solid edges, dashes between.
inline PaintedRoad motorway(Random& random) {
  PaintedRoad road;
  road.course = {random.uniform(-0.5, 0.5), random.uniform(-0.02, 0.02), random.uniform(-4e-4, 4e-4),
                 random.uniform(-2e-6, 2e-6)};
  const double lane = random.uniform(3.5, 3.75);
  const double brightness = random.uniform(40, 90);
  for (int i = 0; i < 4; ++i) {
    PaintedLine line;
    line.lateral = (i - 1.5 + random.uniform(-0.05, 0.05)) * lane;
    line.brightness = brightness;
    if (i == 0 || i == 3) {
      line.width = 0.30;
    } else {
      line.dash = 6;
      line.gap = 12;
      line.phase = random.uniform(0, 18);
    }
    road.lines.push_back(line);
  }
  return road;
}

class RoadPainter {
 public:
  RoadPainter(const CameraModel& camera, std::uint64_t seed) : camera_(camera), random_(seed, "asphalt") {
    for (float& noise : noise_) noise = static_cast<float>(random_.normal(1));
  }

  Image paint(const PaintedRoad& road, const CameraPose& pose) {
    const int width = camera_.intrinsics().width;
    const int height = camera_.intrinsics().height;
    const GroundProjection projection(camera_, pose);
    Image image(width, height, 3);
    std::vector<float> grey(static_cast<std::size_t>(width) * height);
    std::vector<float> yellow(grey.size());
    for (int v = 0; v < height; ++v) {
      float* row = grey.data() + static_cast<std::ptrdiff_t>(v) * width;
      std::fill(row, row + width, static_cast<float>(road.asphalt));
      for (const PaintedLine& line : road.lines) {
        paint_row(road, line, projection, v, row, yellow.data() + static_cast<std::ptrdiff_t>(v) * width);
      }
    }
    blur(grey, width, height, road.blur_px);
    blur(yellow, width, height, road.blur_px);
    for (int v = 0; v < height; ++v) {
      std::size_t at = random_.bits() % noise_.size();
      for (int u = 0; u < width; ++u) {
        const std::size_t i = static_cast<std::size_t>(v) * width + u;
        for (int c = 0; c < 3; ++c) {
          const double level = grey[i] - (c == 0 ? yellow[i] : 0) + road.noise * noise_[at];
          at = (at + 1) % noise_.size();
          image.row(v)[3 * u + c] = static_cast<std::uint8_t>(std::clamp(level + 0.5, 0.0, 255.0));
        }
      }
    }
    return image;
  }

 private:
  static constexpr int kRowParts = 12;
  CameraModel camera_;
  Random random_;
  std::array<float, 65521> noise_{};

  void paint_row(const PaintedRoad& road, const PaintedLine& line, const GroundProjection& projection, int v,
                 float* row, float* yellow) const {
    for (int part = 0; part < kRowParts; ++part) {
      const double at = v - 0.5 + (part + 0.5) / kRowParts;
      double edges[2];
      double x = 0;
      bool seen = true;
      for (int side = 0; side < 2 && seen; ++side) {
        edges[side] = camera_.intrinsics().cx;
        for (int i = 0; i < 6 && seen; ++i) {
          const auto ground = projection.ground({edges[side], at});
          seen = ground && ground->x() < 400;
          if (!seen) break;
          x = ground->x();
          const double y =
              road.y(line, x) + (side == 0 ? 0.5 : -0.5) * line.width * std::hypot(1, road.course.slope(x));
          const auto pixel = projection.pixel({x, y});
          seen = pixel.has_value();
          if (seen) edges[side] = pixel->x();
        }
      }
      if (!seen || !PaintedRoad::painted(line, x)) continue;
      const int begin = std::max(0, static_cast<int>(std::floor(edges[0] + 0.5)));
      const int end = std::min(camera_.intrinsics().width - 1, static_cast<int>(std::floor(edges[1] + 0.5)));
      for (int u = begin; u <= end; ++u) {
        const double share = std::min(edges[1], u + 0.5) - std::max(edges[0], u - 0.5);
        row[u] += static_cast<float>(share * line.brightness / kRowParts);
        if (line.yellow) yellow[u] += static_cast<float>(share * 1.2 * line.brightness / kRowParts);
      }
    }
  }

  static void blur(std::vector<float>& pixels, int width, int height, double sigma) {
    if (sigma <= 0) return;
    const auto side = static_cast<float>(std::exp(-0.5 / (sigma * sigma)));
    const auto far = static_cast<float>(std::exp(-2 / (sigma * sigma)));
    const float sum = 1 + 2 * side + 2 * far;
    const float kernel[] = {1 / sum, side / sum, far / sum};
    std::vector<float> source = pixels;
    for (const std::ptrdiff_t step : {std::ptrdiff_t{1}, static_cast<std::ptrdiff_t>(width)}) {
      for (std::size_t i = 2 * width; i + 2 * width < pixels.size(); ++i) {
        const float* s = source.data() + i;
        pixels[i] =
            kernel[0] * s[0] + kernel[1] * (s[-step] + s[step]) + kernel[2] * (s[-2 * step] + s[2 * step]);
      }
      source = pixels;
    }
    (void)height;
  }
};

}  // namespace lanefuse::testing
