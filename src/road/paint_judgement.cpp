// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// What a frame of paint says of the lines themselves: which of its paint is void, which line has gone its own
// way, and whether all of them may be taken for their neighbours.
#include <algorithm>

#include "road/paint_update.hpp"

namespace lanefuse {
namespace {

constexpr double kRestless = 2.5e-4;  ///< [1/m] over one knot spacing: on calmer roads it does not happen
constexpr double kBeyond = 1.5;       ///< [m] beyond the outermost line: too far to be on it
constexpr double kNextLane = 5;       ///< [m] beyond it: a lane further
constexpr double kNear = 40;          ///< [m] ahead, where lines are put in order
constexpr std::size_t kFewInBand = 3;
constexpr std::size_t kPulling = 5;  ///< features of a frame
constexpr double kDensityGain = 0.2;
constexpr double kPulledFrames = 3;
constexpr double kFreedBefore = 25;  ///< [m] before the first such band
constexpr double kFreedSigma = 0.5;  ///< [m]
constexpr std::size_t kFewYellow = 2;
constexpr std::size_t kEnoughYellow = 8;

}  // namespace

/// Where a road is being built, yellow paint on both sides of the car makes the white void; on the left alone
/// it is America's edge of the road. Single features may be mistaken.
void PaintUpdate::find_yellow(const Pose2& now_from_measured, const RoadState& state) {
  std::size_t count = 0;
  std::size_t on_left = 0;
  yellow_begin_ = 1e9;
  yellow_end_ = -1e9;
  for (const Feature* feature : by_range_) {
    if (feature->marking.colour != MarkingColour::yellow) continue;
    const Eigen::Vector2d place = now_from_measured * Eigen::Vector2d(feature->x, feature->y);
    if (state.axis().project(place).lateral > 0) ++on_left;
    if (++count == kFewYellow) yellow_begin_ = feature->x;
    if (count > kFewYellow) yellow_end_ = feature->x;
  }
  const bool on_both_sides = std::min(on_left, count - on_left) >= kFewYellow;
  if (count < kEnoughYellow || !on_both_sides) yellow_begin_ = 1e9;
}

bool PaintUpdate::is_void(const Feature& feature) const {
  return feature.marking.colour == MarkingColour::white && feature.x >= yellow_begin_ &&
         feature.x <= yellow_end_;
}

/// A line whose paint is again and again beside it has gone its own way: an exit, a lane that ends.
void PaintUpdate::let_go(RoadState& state) {
  for (std::size_t i = 0; i < state.lines().size(); ++i) {
    KnownLine& line = state.lines()[i];
    const Near& near = near_[i];
    line.density += kDensityGain * (static_cast<double>(near.on) - line.density);
    const std::size_t more = std::max(near.left, near.right);
    const bool pulled = more >= kPulling && more > 4 * std::min(near.left, near.right);
    line.pull = pulled ? line.pull + 1 : line.pull * 0.6;
    if (line.pull < kPulledFrames) continue;
    line.pull = 1;
    state.free_line(line, near.from - kFreedBefore, kFreedSigma);
  }
}

/// Whether the lines may be what the band shows. Where all of them are taken for their neighbours, all but
/// one find paint; that one finds none, and there is paint a lane beyond the other side: then none of it is
/// believed.
bool PaintUpdate::is_explained(std::size_t first_stray, const RoadState& state) {
  const auto& lines = state.lines();
  if (lines.size() < 3 || state.usual_step() < kRestless) return true;
  std::size_t left = 0;
  std::size_t right = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (state.offset(lines[i], kNear) > state.offset(lines[left], kNear)) left = i;
    if (state.offset(lines[i], kNear) < state.offset(lines[right], kNear)) right = i;
  }
  std::size_t beyond_left = 0;
  std::size_t beyond_right = 0;
  for (std::size_t i = first_stray; i < strays_.size(); ++i) {
    const StrayPaint& stray = strays_[i];
    const double from_left = stray.lateral - state.offset(lines[left], stray.station);
    const double from_right = state.offset(lines[right], stray.station) - stray.lateral;
    if (from_left > kBeyond && from_left < kNextLane) ++beyond_left;
    if (from_right > kBeyond && from_right < kNextLane) ++beyond_right;
  }
  const bool aside = (beyond_left >= kFewInBand && given_[right].empty()) ||
                     (beyond_right >= kFewInBand && given_[left].empty());
  if (!aside) return true;
  strays_.resize(first_stray);
  return false;
}

}  // namespace lanefuse
