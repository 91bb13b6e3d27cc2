// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "sensors/rig.hpp"
#include "simulation/image_light.hpp"
#include "simulation/span_coverage.hpp"

namespace lanefuse {

/// A flat convex piece of something, as an image shows it.
struct Face {
  std::vector<Eigen::Vector2d> outline;  ///< [px]
  double top = 0;                        ///< [px] row
  double bottom = 0;                     ///< [px] row
  double distance = 0;                   ///< [m] that decides what hides what
  LinearColour colour = grey(0);         ///< light that reaches the camera
  float opacity = 1;
};

/// Gathers faces of a scene as one camera sees them.
class ImageFaces {
 public:
  /// Both must outlive it.
  ImageFaces(const CameraModel& camera, const Mounting& mounting, const ImageLight& light);

  /// How a face looks before the air comes between.
  struct Paint {
    LinearColour colour = grey(0);
    float opacity = 1;
  };
  /// Corners in the vehicle frame [m], in order around a convex outline; what is behind the camera is cut
  /// off. `distance` [m] decides what hides what.
  void add(const std::vector<Eigen::Vector3d>& corners, double distance, const Paint& paint);

  [[nodiscard]] const ImageLight& light() const { return *light_; }
  /// Of the camera, in the vehicle frame.
  [[nodiscard]] Eigen::Vector3d eye() const { return eye_; }

  /// All faces, the farthest first; faces of one distance in the order in which they came.
  [[nodiscard]] std::vector<Face> sorted() &&;

 private:
  const CameraModel* camera_;
  const ImageLight* light_;
  Eigen::Vector3d eye_;
  Eigen::Matrix3d camera_from_vehicle_;
  std::vector<Face> faces_;
};

/// Faces of an image in the order in which they are drawn, found by the row.
class FacesByRow {
 public:
  FacesByRow(std::vector<Face> faces, int height);

  /// Lays what row `v` shows of them over its pixels; `coverage` is scratch of the row's width, clear before
  /// and after.
  void draw_row(int v, SpanCoverage& coverage, LinearColour* pixels) const;

 private:
  std::vector<Face> faces_;
  std::vector<std::vector<std::uint32_t>> rows_;  ///< indices of the faces that a row shows
};

/// Lays the face's part in row `v` over the pixels; `coverage` is scratch of the row's width, clear before
/// and after.
void draw_row(const Face& face, int v, SpanCoverage& coverage, LinearColour* pixels);

}  // namespace lanefuse
