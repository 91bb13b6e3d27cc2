// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_paint.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kRaggedEdge = 0.006;  ///< [m] sigma of a worn edge
constexpr double kFinestPiece = 0.4;   ///< [m] of way that is sampled at once
constexpr int kMostPieces = 8;         ///< of an image row
constexpr int kSamples = 4;            ///< of a piece, to see the ends of dashes
constexpr float kGhost = 0.35F;        ///< what is left of old paint

constexpr double kSeamWidth = 0.045;  ///< [m]
constexpr double kSeamEvery = 70;     ///< [m] of the road, with a seam or without
constexpr float kTar = 0.6F;          ///< of the light that it swallows

/// Whether a line's seam has been filled with tar there.
bool sealed(int line, double station) {
  const auto piece = static_cast<std::uint64_t>(std::max(0.0, station / kSeamEvery));
  return ((piece * 31 + static_cast<std::uint64_t>(line)) * 0x9e3779b97f4a7c15ULL >> 60) < 7;
}

LinearColour colour_of(const MarkingEvidence& marking, float white) {
  if (marking.colour == MarkingColour::yellow) return white * colour(0.16F, 0.70F, 0.95F);
  return white * colour(0.97F, 1, 1);
}

/// Where a straight function of [0, 1] lies between two bounds.
struct Inside {
  double from = 0;
  double to = 0;
};
Inside inside(double at_0, double at_1, double low, double high) {
  const double rise = at_1 - at_0;
  if (std::abs(rise) < 1e-12) return at_0 > low && at_0 < high ? Inside{0, 1} : Inside{};
  const double a = (low - at_0) / rise;
  const double b = (high - at_0) / rise;
  return {std::clamp(std::min(a, b), 0.0, 1.0), std::clamp(std::max(a, b), 0.0, 1.0)};
}

}  // namespace

RoadPaint::RoadPaint(const Scene& scene, const RoadAhead& road, const SurfaceTextures& textures,
                     const Look& look)
    : scene_(&scene),
      textures_(&textures),
      look_(look),
      first_(std::max(road.first(), 0.0)),
      last_(road.last()) {
  const Road& all = *scene.road;
  const double here = scene.ego.station;
  for (int index = 0; index < all.line_count(); ++index) {
    if (!all.line_runs_within(index, {here + first_, here + last_})) continue;
    const bool ghost = all.parts().lines[static_cast<std::size_t>(index)].ghost;
    if (!ghost && look.seams > 0) add_line(index, Kind::seam);
    add_line(index, ghost ? Kind::ghost : Kind::paint);
  }
}

void RoadPaint::add_line(int index, Kind kind) {
  Line line{index, {}, kind};
  for (double way = first_; way <= last_ + kStep; way += kStep) {
    const double station = scene_->ego.station + way;
    // The pavers' strips meet beside the line, not quite straight.
    const double beside = 0.22 + 0.02 * std::sin(station / 3.1) + 0.015 * std::sin(station / 0.9);
    line.lateral.push_back(
        static_cast<float>(scene_->road->line_lateral(index, station) + (kind == Kind::seam ? beside : 0)));
  }
  lines_.push_back(std::move(line));
}

double RoadPaint::half_width(const Line& line, double station) const {
  return line.kind == Kind::seam ? kSeamWidth / 2 : scene_->road->marking_width(line.index, station) / 2;
}

double RoadPaint::lateral(const Line& line, double way) const {
  const double at = std::clamp((way - first_) / kStep, 0.0, static_cast<double>(line.lateral.size()) - 1.001);
  const auto low = static_cast<std::size_t>(at);
  const double between = at - static_cast<double>(low);
  return line.lateral[low] + between * (line.lateral[low + 1] - line.lateral[low]);
}

float RoadPaint::painted_share(const Line& line, double from, double to) const {
  if (line.kind == Kind::seam) {
    const double station = scene_->ego.station + (from + to) / 2;
    return sealed(line.index, station) && scene_->road->line_exists(line.index, station) ? 1 : 0;
  }
  int painted = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double way = from + (i + 0.5) / kSamples * (to - from);
    painted += scene_->road->painted(line.index, scene_->ego.station + way) ? 1 : 0;
  }
  return static_cast<float>(painted) / kSamples;
}

void RoadPaint::cover(const Line& line, const GroundRow& row, const SubRow& sub_row,
                      SpanCoverage& coverage) const {
  const auto at = [&](std::size_t node) {
    const GroundHit& far = (*row.far)[node];
    const GroundHit& near = (*row.near)[node];
    return RoadPlace{far.way + sub_row.near * (near.way - far.way),
                     far.lateral + sub_row.near * (near.lateral - far.lateral)};
  };
  RoadPlace left = at(0);
  double left_off = left.lateral - lateral(line, left.way);
  for (std::size_t node = 1; node < row.near->size(); ++node) {
    const RoadPlace right = at(node);
    const double right_off = right.lateral - lateral(line, right.way);
    constexpr double kWidest = 0.5;  // [m] half of the widest paint, and more
    if (std::min(left_off, right_off) < kWidest && std::max(left_off, right_off) > -kWidest) {
      const double way = (left.way + right.way) / 2;
      const double depth = sub_row.share * ((*row.far)[node].way - (*row.near)[node].way);
      const float painted = painted_share(line, way - depth / 2, way + depth / 2);
      if (painted > 0) {
        const double station = scene_->ego.station + way;
        const double half = half_width(line, station);
        const TextureTile::Level ragged = textures_->wear.level(std::max(depth, 0.02), 0.02);
        const double worn = look_.wear * kRaggedEdge;
        const double low = -half + worn * ragged.at(station, 1 + line.index);
        const double high = half + worn * ragged.at(station, 2.5 + line.index);
        const Inside part = inside(left_off, right_off, low, high);
        const double begin = static_cast<double>(node - 1) * GroundRays::kSegment;
        coverage.add(begin + part.from * GroundRays::kSegment, begin + part.to * GroundRays::kSegment,
                     sub_row.share * painted);
      }
    }
    left = right;
    left_off = right_off;
  }
}

void RoadPaint::blend(const Line& line, const GroundRow& row, SpanCoverage& coverage,
                      LinearColour* albedo) const {
  const std::vector<GroundHit>& near = *row.near;
  const std::vector<GroundHit>& far = *row.far;
  for (int u = coverage.begin(); u < coverage.end(); ++u) {
    const auto node = static_cast<std::size_t>(u / GroundRays::kSegment);
    const double t = static_cast<double>(u % GroundRays::kSegment) / GroundRays::kSegment;
    const double way = near[node].way + t * (near[node + 1].way - near[node].way);
    const double station = scene_->ego.station + way;
    if (line.kind == Kind::seam) {
      albedo[u] *= 1 - coverage.at(u) * kTar * static_cast<float>(look_.seams);
      continue;
    }
    float share = coverage.at(u) * (line.kind == Kind::ghost ? kGhost : 1.0F);
    if (look_.wear > 0 && share > 0) {
      const double lateral = near[node].lateral + t * (near[node + 1].lateral - near[node].lateral);
      const double across = std::abs(near[node + 1].lateral - near[node].lateral) / GroundRays::kSegment;
      const TextureTile::Level wear = textures_->wear.level(far[node].way - near[node].way, across);
      const float hole = std::clamp(0.9F * (wear.at(station, lateral) - 1.3F), 0.0F, 0.8F);
      share *= 1 - static_cast<float>(look_.wear) * (0.08F + hole);
    }
    const LinearColour paint = colour_of(scene_->road->marking(line.index, station), look_.white);
    albedo[u] += share * (paint - albedo[u]);
  }
}

void RoadPaint::lay(const GroundRow& row, SpanCoverage& coverage, LinearColour* albedo) const {
  const std::size_t middle = row.near->size() / 2;
  const double depth = (*row.far)[middle].way - (*row.near)[middle].way;
  const int pieces = std::clamp(static_cast<int>(std::ceil(depth / kFinestPiece)), 1, kMostPieces);
  for (const Line& line : lines_) {
    for (int i = 0; i < pieces; ++i) {
      cover(line, row, {(i + 0.5) / pieces, 1.0F / static_cast<float>(pieces)}, coverage);
    }
    if (coverage.begin() < coverage.end()) blend(line, row, coverage, albedo);
    coverage.clear();
  }
}

}  // namespace lanefuse
