// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "camera/camera_model.hpp"
#include "camera/ground_projection.hpp"
#include "camera/image.hpp"
#include "core/clothoid.hpp"
#include "core/random.hpp"

namespace lanefuse {

/// The serial camera of the paper, looking along the road from where a rear-view mirror is.
inline CameraIntrinsics serial_camera() {
  return {1176, 640, 1179, 1179, 587.5, 319.5, {-0.05, 0.01, 0, 0, 0}};
}

inline Mounting usual_mounting() { return {0, 0, 1.25, 0, 0.01, 0}; }

/// A line of paint, by its middle, in the vehicle frame of one image.
struct PaintedLine {
  Clothoid middle;
  double width = 0.15;                                ///< [m]
  double mark = 0;                                    ///< [m] of paint in every `period`; 0: solid
  double period = 18;                                 ///< [m]
  double phase = 0;                                   ///< [m] where along x a mark begins
  std::array<std::uint8_t, 3> colour{220, 220, 220};  ///< blue, green, red
};

/// The lines of a road with lanes of one width, the car in the ego lane; dashed but for the outermost.
inline std::vector<PaintedLine> painted_lanes(const Clothoid& ego_middle, double pitch_of_lines, int to_left,
                                              int to_right) {
  std::vector<PaintedLine> lines;
  for (int i = -to_right; i <= to_left + 1; ++i) {
    PaintedLine line;
    line.middle = ego_middle;
    line.middle.lateral_offset += (i - 0.5) * pitch_of_lines;
    if (i > -to_right && i < to_left + 1) line.mark = 6;
    lines.push_back(line);
  }
  return lines;
}

/// Paints images of a road without texture, with area-true columns.
class RoadPainter {
 public:
  explicit RoadPainter(const CameraIntrinsics& intrinsics)
      : camera_(intrinsics), image_(intrinsics.width, intrinsics.height, 3) {
    Random random(11, "grain");
    for (float& grain : grain_) grain = static_cast<float>(random.normal(1));
  }

  const Image& paint(const CameraPose& pose, const std::vector<PaintedLine>& lines, double noise = 0) {
    const GroundProjection projection(camera_, pose);
    const int horizon = static_cast<int>(projection.horizon_row(camera_.intrinsics().cx));
    for (int v = 0; v < image_.height(); ++v) {
      const std::uint8_t shade = v < horizon ? 180 : kRoad;
      std::fill_n(image_.row(v), image_.width() * 3, shade);
    }
    for (const PaintedLine& line : lines) paint_line(projection, line);
    if (noise > 0) add_noise(noise);
    return image_;
  }

 private:
  static constexpr std::uint8_t kRoad = 90;
  static constexpr double kNearest = 3;
  static constexpr double kFarthest = 150;
  CameraModel camera_;
  Image image_;
  std::array<float, 4099> grain_{};

  /// Where a curve crosses the row: distance and column.
  static std::optional<Eigen::Vector2d> crossing(const GroundProjection& projection, const Clothoid& curve,
                                                 double aside, double row) {
    double near = kNearest;
    double far = kFarthest;
    const auto row_at = [&](double x) {
      const auto pixel = projection.pixel({x, curve.y(x) + aside});
      return pixel ? pixel->y() : 1e9;
    };
    if (row_at(near) < row || row_at(far) > row) return {};
    for (int i = 0; i < 26; ++i) {
      const double middle = (near + far) / 2;
      (row_at(middle) > row ? near : far) = middle;
    }
    return Eigen::Vector2d(near, projection.pixel({near, curve.y(near) + aside})->x());
  }

  void paint_line(const GroundProjection& projection, const PaintedLine& line) {
    constexpr int kParts = 3;
    for (int v = 0; v < image_.height(); ++v) {
      for (int part = 0; part < kParts; ++part) {
        const double row = v + (part + 0.5) / kParts - 0.5;
        const auto left = crossing(projection, line.middle, line.width / 2, row);
        const auto right = crossing(projection, line.middle, -line.width / 2, row);
        if (!left || !right) continue;
        if (line.mark > 0 && std::fmod(left->x() - line.phase + 1000 * line.period, line.period) >= line.mark)
          continue;
        cover(v, left->y(), right->y(), 1.0 / kParts, line.colour);
      }
    }
  }

  void cover(int v, double begin, double end, double part, const std::array<std::uint8_t, 3>& colour) {
    const int first = std::max(0, static_cast<int>(std::floor(begin + 0.5)));
    const int last = std::min(image_.width() - 1, static_cast<int>(std::floor(end + 0.5)));
    for (int u = first; u <= last; ++u) {
      const double covered = std::min(end, u + 0.5) - std::max(begin, u - 0.5);
      for (int c = 0; c < 3; ++c) {
        std::uint8_t& value = image_.row(v)[3 * u + c];
        const double change = (colour[static_cast<std::size_t>(c)] - kRoad) * covered * part;
        value = static_cast<std::uint8_t>(std::clamp(value + change + 0.5, 0.0, 255.0));
      }
    }
  }

  void add_noise(double noise) {
    std::size_t next = 0;
    for (int v = 0; v < image_.height(); ++v) {
      std::uint8_t* pixel = image_.row(v);
      for (int i = 0; i < image_.width() * 3; ++i) {
        pixel[i] = static_cast<std::uint8_t>(
            std::clamp(pixel[i] + noise * static_cast<double>(grain_[next]), 0.0, 255.0));
        next = (next + 1) % grain_.size();
      }
    }
  }
};

}  // namespace lanefuse
