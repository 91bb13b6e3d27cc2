// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/neighbour_markings.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kNearest = 8;    ///< [m]
constexpr double kFarthest = 28;  ///< [m]
constexpr double kSpacing = 1.07;
constexpr double kNarrowest = 2.6;  ///< [m] a lane
constexpr double kWidest = 4.4;     ///< [m]
constexpr double kContrast = 8;

}  // namespace

std::size_t NeighbourMarkings::collect(const EdgeScene& scene, const LaneState::Vector& state, Side side) {
  const double pitch = state[LaneState::kPitch];
  const double bend = state[LaneState::kVerticalCurvature];
  const Clothoid edge = LaneState::edge(state, side);
  const double outward = side == Side::left ? 1 : -1;
  const double paint = scene.marking_widths[side == Side::left ? 0 : 1];
  std::size_t count = 0;
  for (double x = kNearest; x <= kFarthest; x *= kSpacing) {
    const auto near_end = scene.sight->pixel({x, edge.y(x) + outward * (paint + kNarrowest)}, pitch, bend);
    const auto far_end = scene.sight->pixel({x, edge.y(x) + outward * (paint + kWidest)}, pitch, bend);
    if (!near_end || !far_end) continue;
    const double pixels_per_metre = std::abs(far_end->x() - near_end->x()) / (kWidest - kNarrowest);
    BarQuery query;
    query.row = static_cast<int>(std::lround((near_end->y() + far_end->y()) / 2));
    query.left = std::max(0, static_cast<int>(std::min(near_end->x(), far_end->x())));
    query.right = std::min(scene.image.width - 1, static_cast<int>(std::max(near_end->x(), far_end->x())));
    if (query.right - query.left < 5) continue;
    query.narrowest = std::max(1.0, 0.08 * pixels_per_metre - 1);
    query.widest = 0.35 * pixels_per_metre + 4;
    query.contrast = kContrast;
    for (const PaintBar& bar : finder_.find(scene.image, query)) {
      const double column = side == Side::left ? bar.right : bar.left;
      if (is_hidden(scene.vehicles, column, query.row)) continue;
      const auto landing =
          scene.sight->landing(scene.sight->ray({column, static_cast<double>(query.row)}), pitch, bend);
      if (!landing) continue;
      const double width = outward * (landing->place.y() - edge.y(landing->place.x())) - paint;
      if (width < kNarrowest || width > kWidest || count == widths_.size()) continue;
      widths_[count++] = width;
    }
  }
  return count;
}

std::optional<NeighbourWidth> NeighbourMarkings::measure(const EdgeScene& scene,
                                                         const LaneState::Vector& state, Side side) {
  const std::size_t count = collect(scene, state, side);
  constexpr double kBin = (kWidest - kNarrowest) / kBins;
  bins_.fill(0);
  for (std::size_t i = 0; i < count; ++i) {
    const int bin = std::clamp(static_cast<int>((widths_[i] - kNarrowest) / kBin), 0, kBins - 1);
    bins_[static_cast<std::size_t>(bin)] += 1;
  }
  int best = 0;
  double most = 0;
  constexpr int kPeak = 3;  // bins: 11 cm
  for (int i = 0; i + kPeak <= kBins; ++i) {
    double votes = 0;
    for (int j = i; j < i + kPeak; ++j) votes += bins_[static_cast<std::size_t>(j)];
    if (votes > most) {
      most = votes;
      best = i;
    }
  }
  // A marking is seen in several rows, and most of what was found is it.
  constexpr double kLeast = 4;
  if (most < kLeast || most < 0.6 * static_cast<double>(count)) return {};
  // At the ends of what was searched stands the flank of something wider.
  if (best < 2 || best + kPeak > kBins - 2) return {};
  const double begin = kNarrowest + best * kBin;
  double sum = 0;
  double squares = 0;
  double used = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double from_begin = widths_[i] - begin;
    if (from_begin < -kBin || from_begin > (kPeak + 1) * kBin) continue;
    sum += from_begin;
    squares += from_begin * from_begin;
    used += 1;
  }
  const double mean = sum / used;
  const double spread = std::max(0.0, squares / used - mean * mean);
  return NeighbourWidth{begin + mean, std::sqrt(spread / used + 0.02 * 0.02)};
}

}  // namespace lanefuse
