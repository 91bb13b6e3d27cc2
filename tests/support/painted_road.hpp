// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "camera/ground_projection.hpp"
#include "camera/image.hpp"

namespace lanefuse::testing {

/// A flat road of random texture, the same for every call, and a camera that is driven over it.
class PaintedRoad {
 public:
  /// `contrast` 1: rough; less: smoother.
  explicit PaintedRoad(const CameraModel& camera, double contrast = 1)
      : camera_(camera), contrast_(contrast) {}

  struct View {
    double x = 0;    ///< [m] of the vehicle in the road's frame
    double y = 0;    ///< [m]
    double yaw = 0;  ///< [rad]
    CameraPose pose;
  };

  /// Blue, green and red alike.
  [[nodiscard]] Image paint(const View& view) const {
    const CameraIntrinsics& size = camera_.intrinsics();
    const GroundProjection projection(camera_, view.pose);
    Image image(size.width, size.height, 3);
    for (int v = 0; v < size.height; ++v) {
      for (int u = 0; u < size.width; ++u) {
        const auto ground = projection.ground({u, v});
        const double grey = ground ? brightness(view, *ground) : kSky;
        std::fill_n(image.row(v) + 3 * u, 3, static_cast<std::uint8_t>(std::lround(grey)));
      }
    }
    return image;
  }

 private:
  static constexpr double kSky = 200;
  CameraModel camera_;
  double contrast_;

  /// In [0, 1], by integers only: the same on every machine.
  static double random_at(std::int64_t i, std::int64_t j) {
    std::uint64_t z = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(j);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) / 9007199254740992.0;
  }

  /// Smooth between points of a grid.
  static double noise(double x, double y, double grid) {
    const double i = std::floor(x / grid);
    const double j = std::floor(y / grid);
    const double a = x / grid - i;
    const double b = y / grid - j;
    const auto at = [&](int di, int dj) {
      return random_at(static_cast<std::int64_t>(i) + di, static_cast<std::int64_t>(j) + dj);
    };
    return (1 - a) * ((1 - b) * at(0, 0) + b * at(0, 1)) + a * ((1 - b) * at(1, 0) + b * at(1, 1));
  }

  [[nodiscard]] double brightness(const View& view, const Eigen::Vector2d& ground) const {
    const double x = view.x + std::cos(view.yaw) * ground.x() - std::sin(view.yaw) * ground.y();
    const double y = view.y + std::sin(view.yaw) * ground.x() + std::cos(view.yaw) * ground.y();
    return 115 + contrast_ * (60 * noise(x, y, 0.5) + 30 * noise(x + 100, y, 0.17) - 45);
  }
};

}  // namespace lanefuse::testing
