// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/ground_rays.hpp"
#include "simulation/road_surface.hpp"
#include "simulation/span_coverage.hpp"

namespace lanefuse {

/// One row of pixels on the ground: hits at the ends of its segments along its upper and its lower edge.
struct GroundRow {
  const std::vector<GroundHit>* far = nullptr;
  const std::vector<GroundHit>* near = nullptr;
};

/// The paint of one scene: every line with its width and dashes, its share of each pixel exact across the
/// line and finely sampled along it. Worn paint has ragged edges and holes. Beside the lanes' lines run seams
/// of tar, with gaps.
class RoadPaint {
 public:
  struct Look {
    float white = 0.6F;  ///< albedo
    double wear = 1;     ///< 0: as new
    double seams = 1;    ///< how black the seams of tar are
  };
  RoadPaint(const Scene& scene, const RoadAhead& road, const SurfaceTextures& textures, const Look& look);

  /// Lays the paint onto a row of albedos; `coverage` is scratch of the row's width, clear before and after.
  void lay(const GroundRow& row, SpanCoverage& coverage, LinearColour* albedo) const;

 private:
  enum class Kind : std::uint8_t { paint = 0, ghost = 1, seam = 2 };
  struct Line {
    int index = 0;
    std::vector<float> lateral;  ///< [m] every kStep of way
    Kind kind = Kind::paint;
  };
  /// A piece of one image row as the ground sees it.
  struct SubRow {
    double near = 0;  ///< share of the way from the row's far edge to its near one
    float share = 0;  ///< of the row's height
  };
  static constexpr double kStep = 0.5;

  const Scene* scene_;
  const SurfaceTextures* textures_;
  Look look_;
  double first_;  ///< [m] way
  double last_;   ///< [m] way
  std::vector<Line> lines_;

  void add_line(int index, Kind kind);
  [[nodiscard]] double half_width(const Line& line, double station) const;
  [[nodiscard]] double lateral(const Line& line, double way) const;
  void cover(const Line& line, const GroundRow& row, const SubRow& sub_row, SpanCoverage& coverage) const;
  [[nodiscard]] float painted_share(const Line& line, double from, double to) const;
  void blend(const Line& line, const GroundRow& row, SpanCoverage& coverage, LinearColour* albedo) const;
};

}  // namespace lanefuse
