// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/vehicle_cues.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr float kMostGradient = 30;  ///< grey levels: one bright edge is no more than many

/// Brightness changes along the row (upright edges) or down the column (level edges).
NumberImage edges_of(const NumberImage& brightness, bool level) {
  NumberImage edges(brightness.width, brightness.height);
  for (int v = level ? 1 : 0; v + (level ? 1 : 0) < brightness.height; ++v) {
    const float* before = level ? brightness.row(v - 1) : brightness.row(v) - 1;
    const float* after = level ? brightness.row(v + 1) : brightness.row(v) + 1;
    float* out = edges.row(v);
    for (int u = 1; u + 1 < brightness.width; ++u)
      out[u] = std::min(std::abs(after[u] - before[u]), kMostGradient);
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
  constexpr double kUsualMotion = 0.4;  // of cars whose lower half is mostly smooth
  const double sum = 0.3 * shadow + 0.125 * (left_edge + right_edge) + 0.25 * body +
                     0.2 * std::min(1.0, motion / kUsualMotion);
  // Nothing on one side is no car, whatever else there is.
  return sum * (0.4 + 0.6 * std::min(left_edge, right_edge));
}

VehicleCues::VehicleCues(const NumberImage& brightness, const NumberImage& residual)
    : brightness_(brightness),
      upright_(edges_of(brightness, false)),
      level_(edges_of(brightness, true)),
      residual_(residual),
      has_residual_(!residual.values.empty()) {}

/// An upright edge in the lower half of a box: strong on it, weak on what is just outside, which looks like
/// the road before the box and not like the next car.
double VehicleCues::edge(const PixelBox& box, double column, double outward) const {
  const double top = box.top + 0.4 * box.height();
  const double bottom = box.bottom - 0.08 * box.height();
  const double wide = std::max(1.0, 0.05 * box.height());
  const double on = upright_.mean({column - wide, top, column + wide, bottom});
  const double far = outward * (0.3 * box.height() + 3);
  const double near = outward * (wide + 1);
  const double left = column + std::min(far, near);
  const double right = column + std::max(far, near);
  constexpr double kClear = 12;       // grey levels
  constexpr double kSameRoad = 8;     // grey levels
  constexpr double kOtherThing = 30;  // grey levels, and half the road's
  const double road =
      brightness_.mean({box.left, box.bottom + 1, box.right, box.bottom + 1 + 0.2 * box.height()});
  const double outside = brightness_.mean({left, box.bottom - 0.45 * box.height(), right, box.bottom});
  const double other = clamped((std::abs(outside - road) - kSameRoad) / (kOtherThing + 0.3 * road));
  return clamped((on - upright_.mean({left, top, right, bottom})) / kClear) * (1 - other);
}

double VehicleCues::shadow(const VehicleShape& shape) const {
  // The base line runs level along the rear only; of a car whose rear is beside the image all that is seen.
  const PixelBox& box = shape.box;
  constexpr double kLeastRear = 4;  // [px]
  double left = std::max(shape.rear_left, box.left);
  double right = std::min(shape.rear_right, box.right);
  if (right - left < kLeastRear) {
    left = box.left;
    right = box.right;
  }
  const double inset = 0.12 * (right - left);
  const double strip = std::max(1.5, 0.1 * box.height());
  const double dark = brightness_.mean({left + inset, box.bottom - strip, right - inset, box.bottom});
  const double road = brightness_.mean({left + inset, box.bottom + 1, right - inset, box.bottom + 1 + strip});
  constexpr double kGrey = 8;
  return clamped((road - dark) / (0.45 * road + kGrey));
}

VehicleEvidence VehicleCues::evidence(const VehicleShape& shape) const {
  constexpr double kUnknownEdge = 0.7;    // cut by the image's edge
  constexpr double kUnknownMotion = 0.2;  // in a first image
  constexpr double kBreaks = 0.8;         // of a texture's contrast
  constexpr double kBusy = 14;            // grey levels
  const PixelBox& box = shape.box;
  const double height = box.height();
  const PixelBox lower{box.left, box.top + 0.45 * height, box.right, box.bottom};
  const PixelBox middle{box.left + 0.25 * box.width(), box.top + 0.3 * height, box.right - 0.25 * box.width(),
                        box.bottom - 0.12 * height};
  const PixelBox before{box.left, box.bottom + 2, box.right, box.bottom + 2 + 0.25 * height};
  VehicleEvidence evidence;
  evidence.shadow = shadow(shape);
  evidence.left_edge = shape.left_cut ? kUnknownEdge : edge(box, box.left, -1);
  evidence.right_edge = shape.right_cut ? kUnknownEdge : edge(box, box.right, 1);
  evidence.motion =
      has_residual_ ? clamped((residual_.mean(lower) - residual_.mean(before)) / kBreaks) : kUnknownMotion;
  const auto busy = [this](const PixelBox& part) { return upright_.mean(part) + level_.mean(part); };
  evidence.body = clamped((busy(middle) - busy(before)) / kBusy);
  return evidence;
}

VehicleShape VehicleCues::refined(VehicleShape shape) const {
  double best = evidence(shape).score();
  const auto try_all = [&](double step, auto move) {
    VehicleShape kept = shape;
    for (int i = -4; i <= 4; ++i) {
      VehicleShape moved = shape;
      move(moved, i * step);
      const double score = evidence(moved).score();
      if (score <= best) continue;
      best = score;
      kept = moved;
    }
    shape = kept;
  };
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    const double across = std::max(1.0, 0.03 * shape.box.width());
    if (!shape.left_cut) {
      try_all(across, [](VehicleShape& moved, double by) {
        moved.box.left += by;
        moved.rear_left += by;
      });
    }
    if (!shape.right_cut) {
      try_all(across, [](VehicleShape& moved, double by) {
        moved.box.right += by;
        moved.rear_right += by;
      });
    }
    try_all(std::max(0.5, 0.02 * shape.box.height()),
            [](VehicleShape& moved, double by) { moved.box.bottom += by; });
  }
  return shape;
}

}  // namespace lanefuse
