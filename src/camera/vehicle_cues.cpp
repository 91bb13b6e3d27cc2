// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/vehicle_cues.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr float kMostGradient = 30;  ///< grey levels: one bright edge is no more than many

/// Brightness changes along the row: upright edges.
NumberImage upright_edges(const NumberImage& brightness) {
  NumberImage edges(brightness.width, brightness.height);
  for (int v = 0; v < brightness.height; ++v) {
    const float* in = brightness.row(v);
    float* out = edges.row(v);
    for (int u = 1; u + 1 < brightness.width; ++u)
      out[u] = std::min(std::abs(in[u + 1] - in[u - 1]), kMostGradient);
  }
  return edges;
}

double clamped(double value) { return std::clamp(value, 0.0, 1.0); }

}  // namespace

SummedImage::SummedImage(const NumberImage& image)
    : width_(image.width),
      height_(image.height),
      sums_(static_cast<std::size_t>(image.width + 1) * static_cast<std::size_t>(image.height + 1)) {
  const auto stride = static_cast<std::size_t>(width_) + 1;
  for (int v = 0; v < height_; ++v) {
    const float* in = image.row(v);
    const double* above = sums_.data() + static_cast<std::size_t>(v) * stride;
    double* out = sums_.data() + (static_cast<std::size_t>(v) + 1) * stride;
    double row = 0;
    for (int u = 0; u < width_; ++u) {
      row += static_cast<double>(in[u]);
      out[u + 1] = above[u + 1] + row;
    }
  }
}

double SummedImage::mean(const PixelBox& box) const {
  const auto cut = [](double value, int end) {
    return static_cast<int>(std::clamp(std::floor(value + 0.5), 0.0, static_cast<double>(end)));
  };
  const int left = cut(box.left, width_);
  const int right = cut(box.right, width_);
  const int top = cut(box.top, height_);
  const int bottom = cut(box.bottom, height_);
  if (left >= right || top >= bottom) return 0;
  const auto at = [this](int u, int v) {
    return sums_[static_cast<std::size_t>(v) * (static_cast<std::size_t>(width_) + 1) +
                 static_cast<std::size_t>(u)];
  };
  const double sum = at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
  return sum / (static_cast<double>(right - left) * (bottom - top));
}

double VehicleEvidence::score() const {
  return 0.3 * shadow + 0.17 * left_edge + 0.17 * right_edge + 0.26 * motion + 0.1 * texture;
}

VehicleCues::VehicleCues(const NumberImage& brightness, const NumberImage& residual)
    : brightness_(brightness),
      upright_(upright_edges(brightness)),
      residual_(residual),
      has_residual_(!residual.values.empty()) {}

/// An upright edge in the lower half of a box: strong on it, weak on the road just outside.
double VehicleCues::edge(const PixelBox& box, double column, double outward) const {
  const double top = box.top + 0.4 * box.height();
  const double bottom = box.bottom - 0.08 * box.height();
  const double wide = std::max(1.0, 0.05 * box.height());
  const double on = upright_.mean({column - wide, top, column + wide, bottom});
  const double far = outward * (0.25 * box.height() + 3);
  const double near = outward * (wide + 1);
  const double off = upright_.mean({column + std::min(far, near), top, column + std::max(far, near), bottom});
  constexpr double kClear = 12;  // grey levels
  return clamped((on - off) / kClear);
}

VehicleEvidence VehicleCues::evidence(const VehicleShape& shape) const {
  const PixelBox& box = shape.box;
  const double height = box.height();
  // The base line runs level along the rear only; of a car whose rear is beside the image all that is seen.
  double left = std::max(shape.rear_left, box.left);
  double right = std::min(shape.rear_right, box.right);
  if (right - left < 4) {
    left = box.left;
    right = box.right;
  }
  const double inset = 0.12 * (right - left);
  left += inset;
  right -= inset;
  const double strip = std::max(1.5, 0.1 * height);
  VehicleEvidence evidence;
  const double dark = brightness_.mean({left, box.bottom - strip, right, box.bottom});
  const double road = brightness_.mean({left, box.bottom + 1, right, box.bottom + 1 + strip});
  constexpr double kGrey = 8;
  evidence.shadow = clamped((road - dark) / (0.45 * road + kGrey));
  evidence.left_edge = shape.left_cut ? 0.3 : edge(box, box.left, -1);
  evidence.right_edge = shape.right_cut ? 0.3 : edge(box, box.right, 1);
  const PixelBox lower{box.left, box.top + 0.45 * height, box.right, box.bottom};
  const PixelBox before{box.left, box.bottom + 1, box.right, box.bottom + 1 + 0.25 * height};
  constexpr double kBreaks = 0.8;  // of a texture's contrast
  if (has_residual_) evidence.motion = clamped((residual_.mean(lower) - residual_.mean(before)) / kBreaks);
  constexpr double kBusy = 8;  // grey levels
  evidence.texture = clamped((upright_.mean(lower) - upright_.mean(before)) / kBusy);
  return evidence;
}

}  // namespace lanefuse
