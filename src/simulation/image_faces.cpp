// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simulation/ground_rays.hpp"
#include "simulation/image_air.hpp"

namespace lanefuse {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

/// What of the outline lies where `inside` is not negative.
template <typename Inside>
Corners clipped(const Corners& corners, Inside inside) {
  Corners kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = corners[i];
    const Eigen::Vector3d& b = corners[(i + 1) % corners.size()];
    const double at_a = inside(a);
    const double at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

/// In the camera's frame, x ahead: what lies well before it and not far off its axis.
Corners in_front(const Corners& corners) {
  constexpr double kNearest = 0.3;  // [m]
  constexpr double kWidest = 1.8;   // tangent of the angle off the axis
  Corners kept = clipped(corners, [](const Eigen::Vector3d& p) { return p.x() - kNearest; });
  for (const int axis : {1, 2}) {
    kept = clipped(kept, [axis](const Eigen::Vector3d& p) { return kWidest * p.x() - p[axis]; });
    kept = clipped(kept, [axis](const Eigen::Vector3d& p) { return kWidest * p.x() + p[axis]; });
  }
  return kept;
}

/// Lays the face's part in row `v` over the pixels.
void draw_face(const Face& face, int v, SpanCoverage& coverage, LinearColour* pixels) {
  constexpr int kSubRows = 4;
  for (int i = 0; i < kSubRows; ++i) {
    const double row = v - 0.5 + (i + 0.5) / kSubRows;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t k = 0; k < face.outline.size(); ++k) {
      const Eigen::Vector2d& a = face.outline[k];
      const Eigen::Vector2d& b = face.outline[(k + 1) % face.outline.size()];
      if ((a.y() <= row) == (b.y() <= row)) continue;
      const double column = a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      left = std::min(left, column);
      right = std::max(right, column);
    }
    coverage.add(left, right, 1.0F / kSubRows);
  }
  for (int u = coverage.begin(); u < coverage.end(); ++u) {
    pixels[u] += coverage.at(u) * face.opacity * (face.colour - pixels[u]);
  }
  coverage.clear();
}

}  // namespace

ImageFaces::ImageFaces(const CameraModel& camera, const Mounting& mounting, const ImageLight& light)
    : camera_(&camera),
      light_(&light),
      eye_(mounting.x, mounting.y, mounting.z),
      camera_from_vehicle_(vehicle_from_camera(mounting).transpose()) {}

void ImageFaces::add(const Corners& corners, double distance, const Paint& paint) {
  Corners seen;
  for (const Eigen::Vector3d& corner : corners) seen.push_back(camera_from_vehicle_ * (corner - eye_));
  Face face;
  face.top = std::numeric_limits<double>::infinity();
  face.bottom = -face.top;
  for (const Eigen::Vector3d& p : in_front(seen)) {
    const auto pixel = camera_->pixel({-p.y() / p.x(), -p.z() / p.x()});
    if (!pixel) return;
    face.outline.push_back(*pixel);
    face.top = std::min(face.top, pixel->y());
    face.bottom = std::max(face.bottom, pixel->y());
  }
  if (face.outline.size() < 3) return;
  face.distance = distance;
  face.colour = through_air(paint.colour, distance, *light_);
  face.opacity = paint.opacity;
  faces_.push_back(std::move(face));
}

std::vector<Face> ImageFaces::sorted() && {
  std::stable_sort(faces_.begin(), faces_.end(),
                   [](const Face& a, const Face& b) { return a.distance > b.distance; });
  return std::move(faces_);
}

FacesByRow::FacesByRow(std::vector<Face> faces, int height)
    : faces_(std::move(faces)), rows_(static_cast<std::size_t>(height)) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const double first = std::max(0.0, std::floor(faces_[i].top + 0.5));
    const double last = std::min(height - 1.0, std::floor(faces_[i].bottom + 0.5));
    for (double v = first; v <= last; ++v) {
      rows_[static_cast<std::size_t>(v)].push_back(static_cast<std::uint32_t>(i));
    }
  }
}

void FacesByRow::draw_row(int v, SpanCoverage& coverage, LinearColour* pixels) const {
  for (const std::uint32_t i : rows_[static_cast<std::size_t>(v)]) draw_face(faces_[i], v, coverage, pixels);
}

}  // namespace lanefuse
