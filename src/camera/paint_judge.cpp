// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/paint_judge.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kMeasurable = 6;       ///< [px] bars of this width and more show how they grow
constexpr double kTellingAngle = 0.03;  ///< [rad] between the road and a ray that chains can tell apart
constexpr int kRowsToTell = 4;          ///< bars that tell whether something stands upright
constexpr double kDark = 20;            ///< [grey levels] of roads too dark for ratios
constexpr double kLongestDash = 14;     ///< [m]
constexpr double kShortestSolid = 20;   ///< [m]

const RoadBar& at(const std::vector<RoadBar>& bars, int i) { return bars[static_cast<std::size_t>(i)]; }

/// How much brighter than the road beside it: what paint keeps in the shade.
double brightness_of(const RoadBar& bar) { return bar.bar.contrast / (bar.bar.road + kDark); }

}  // namespace

void PaintJudge::cut_into_pieces(const std::vector<RoadBar>& bars, const BarChain& chain) {
  for (int first = chain.first; first >= 0;) {
    int last = first;
    int middle = first;
    int count = 1;
    for (int i = at(bars, first).next; i >= 0; i = at(bars, i).next) {
      if (count >= 3 && at(bars, i).x - at(bars, first).x > config_.piece_length) break;
      last = i;
      if (++count % 2 == 0) middle = at(bars, middle).next;
    }
    if (count >= 2) {
      const RoadBar& bar = at(bars, middle);
      pieces_.push_back({bar.x, bar.y, std::tan(bar.heading), bar.y_sigma, bar.heading_sigma,
                         at(bars, last).x - at(bars, first).x});
    }
    first = at(bars, last).next;
  }
}

/// What stands on the road keeps its columns from row to row, as if it pointed at the camera, where paint
/// runs along the road; straight ahead, where the two are one, it keeps its width.
bool PaintJudge::stands_upright(const std::vector<RoadBar>& bars, const BarChain& chain) const {
  const RoadBar& first = at(bars, chain.first);
  const RoadBar& last = at(bars, chain.last);
  if (chain.count < kRowsToTell) return false;
  const double slope = (last.y - first.y) / (last.x - first.x);
  const double x = (first.x + last.x) / 2;
  const double y = (first.y + last.y) / 2;
  const double upright = y / x;
  const double along = lines_.slope(x, y);
  if (std::abs(upright - along) > kTellingAngle) return std::abs(slope - upright) < std::abs(slope - along);
  const double width = first.bar.right - first.bar.left;
  if (width < kMeasurable || last.x < 1.25 * first.x) return false;
  return std::log(last.width / first.width) > 0.6 * std::log(last.x / first.x);
}

void PaintJudge::measure_brightness(const std::vector<RoadBar>& bars, std::span<const BarChain> chains) {
  brightness_.clear();
  for (const BarChain& chain : chains) {
    if (chain.count < config_.sure_count / 2) continue;
    for (int i = chain.first; i >= 0; i = at(bars, i).next) brightness_.push_back(brightness_of(at(bars, i)));
  }
  usual_brightness_ = 0;
  if (brightness_.empty()) return;
  const auto middle = brightness_.begin() + static_cast<std::ptrdiff_t>(brightness_.size() / 2);
  std::nth_element(brightness_.begin(), middle, brightness_.end());
  usual_brightness_ = *middle;
}

/// Tyre marks, seams and streaks of dirt run along the road, too, but are hardly brighter than it.
bool PaintJudge::is_dull(const std::vector<RoadBar>& bars, const BarChain& chain) const {
  double sum = 0;
  for (int i = chain.first; i >= 0; i = at(bars, i).next) sum += brightness_of(at(bars, i));
  return sum < config_.brightness_min * usual_brightness_ * chain.count;
}

/// Long paint is believed for itself, and so are dashes near the car that run about along the road, even if
/// the shape of its lines is not quite understood.
bool PaintJudge::runs_alone(const std::vector<RoadBar>& bars, const BarChain& chain) const {
  const RoadBar& first = at(bars, chain.first);
  const RoadBar& last = at(bars, chain.last);
  if (chain.count >= config_.sure_count && chain.length >= config_.sure_length && first.x < config_.far)
    return true;
  if (chain.count < config_.far_count || chain.length < config_.near_length) return false;
  if (last.x > config_.near || std::abs(first.y) > config_.near_lateral) return false;
  const double slope = (last.y - first.y) / (last.x - first.x);
  return std::abs(slope - lines_.slope(first.x, first.y)) < config_.near_heading_gate;
}

bool PaintJudge::fits_a_line(const RoadBar& bar, const BarChain& chain) const {
  const double place = lines_.offset(bar.x, bar.y);
  const double gate = config_.place_gate + config_.place_gate_growth * bar.x;
  const ParallelLines::Line* line = lines_.nearest(place, gate);
  if (!line || line->length < config_.line_length_min) return false;
  if ((bar.x > config_.far && chain.count < config_.far_count) || chain.count < 3) {
    if (line->length - chain.length < config_.line_length_min) return false;
  }
  if (chain.count < 2) return bar.x > config_.far / 2;
  const double off = bar.heading - std::atan(lines_.slope(bar.x, bar.y));
  return std::abs(off) < config_.heading_gate + 3 * std::min(bar.heading_sigma, 0.05);
}

void PaintJudge::judge_chain(std::vector<RoadBar>& bars, const BarChain& chain) {
  if (stands_upright(bars, chain) || is_dull(bars, chain)) return;
  const bool sure = runs_alone(bars, chain);
  for (int i = chain.first; i >= 0; i = at(bars, i).next) {
    RoadBar& bar = bars[static_cast<std::size_t>(i)];
    bar.believed = !bar.faint && (sure || fits_a_line(bar, chain));
    if (bar.believed && bar.heading_sigma > config_.heading_gate) {
      bar.heading = std::atan(lines_.slope(bar.x, bar.y));
      bar.heading_sigma = config_.heading_gate;
    }
  }
}

void PaintJudge::measure_lines(const std::vector<RoadBar>& bars, std::span<const BarChain> chains) {
  shapes_.assign(lines_.lines().size(), {});
  for (const BarChain& chain : chains) {
    const RoadBar& first = at(bars, chain.first);
    const RoadBar& last = at(bars, chain.last);
    if (!first.believed || chain.count < 2 || first.x > config_.far) continue;
    const ParallelLines::Line* line = lines_.nearest(
        lines_.offset(first.x, first.y), config_.place_gate + config_.place_gate_growth * first.x);
    if (!line) continue;
    LineShape& shape = shapes_[static_cast<std::size_t>(line - lines_.lines().data())];
    shape.begin = shape.chains == 0 ? first.x : std::min(shape.begin, first.x);
    shape.end = std::max(shape.end, last.x);
    shape.longest = std::max(shape.longest, chain.length);
    shape.painted += chain.length;
    ++shape.chains;
  }
}

MarkingType PaintJudge::type_of(const RoadBar& bar) const {
  const ParallelLines::Line* line =
      lines_.nearest(lines_.offset(bar.x, bar.y), config_.place_gate + config_.place_gate_growth * bar.x);
  if (!line) return MarkingType::unknown;
  const LineShape& shape = shapes_[static_cast<std::size_t>(line - lines_.lines().data())];
  if (shape.longest > kShortestSolid) return MarkingType::solid;
  const double seen = shape.end - shape.begin;
  if (shape.chains >= 2 && shape.longest < kLongestDash && shape.painted < 0.7 * seen && seen > 15) {
    return MarkingType::dashed;
  }
  return MarkingType::unknown;
}

void PaintJudge::find_lines(const std::vector<RoadBar>& bars, std::span<const BarChain> chains,
                            double stretch_sigma) {
  pieces_.clear();
  for (const BarChain& chain : chains) cut_into_pieces(bars, chain);
  lines_.fit(pieces_, stretch_sigma);
}

void PaintJudge::judge(std::vector<RoadBar>& bars, std::span<const BarChain> chains) {
  measure_brightness(bars, chains);
  for (const BarChain& chain : chains) judge_chain(bars, chain);
  measure_lines(bars, chains);
}

}  // namespace lanefuse
