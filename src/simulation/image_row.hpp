// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "simulation/camera_renderer.hpp"
#include "simulation/ground_rays.hpp"
#include "simulation/ground_shade.hpp"
#include "simulation/image_backdrop.hpp"
#include "simulation/image_faces.hpp"
#include "simulation/road_ahead.hpp"
#include "simulation/road_paint.hpp"
#include "simulation/road_surface.hpp"

namespace lanefuse {

/// One scene made ready to be rendered from one camera; it does not change while rows are painted.
class ImageScene {
 public:
  struct View {
    const Scene& scene;
    const CameraModel& camera;
    const SegmentEnds& ends;
    const Mounting& mounting;
  };
  ImageScene(const View& view, const RenderConfig& config, const ImageLight& light,
             const SurfaceTextures& textures);

  [[nodiscard]] Time time() const { return time_; }

 private:
  friend class ImageRowPainter;
  Time time_;
  const SegmentEnds* ends_;
  int width_;
  ImageLight light_;
  double sun_bearing_;  ///< [rad] in the vehicle frame
  RoadAhead road_;
  GroundRays rays_;
  RoadSurface surface_;
  RoadPaint paint_;
  GroundShade shade_;
  ImageBackdrop backdrop_;
  FacesByRow on_road_;  ///< shadows and mirror images
  FacesByRow faces_;
};

/// Paints rows of a scene from top to bottom, one after the other.
class ImageRowPainter {
 public:
  explicit ImageRowPainter(const ImageScene& scene);

  /// The light that reaches the pixels of row `v`.
  void paint(int v, LinearColour* pixels);

 private:
  const ImageScene* scene_;
  std::vector<GroundHit> far_;
  std::vector<GroundHit> near_;
  std::optional<int> near_row_;  ///< whose lower edge near_ is
  SpanCoverage coverage_;
  std::vector<LinearColour> albedo_;

  void cast(int v);
  /// Of the middle of the row, at a segment's end.
  [[nodiscard]] RoadPlace place(std::size_t node) const;
  [[nodiscard]] Footprint footprint(std::size_t node) const;
  void paint_ground(LinearColour* pixels);
  [[nodiscard]] float mirrored(const GroundHit& hit) const;
  void light_segment(int node, const LinearColour* albedo, LinearColour* pixels) const;
};

}  // namespace lanefuse
