// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/edge_search.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kWidestPart = 0.35;  ///< of the lane: a window never reaches the next marking
constexpr double kSharp = 5;          ///< [px] narrower bars are as wide as the blur makes them

/// Where the inner edge of a bar is [px].
double inner_edge(const PaintBar& bar, Side side, double marking_width_px) {
  const double middle = (bar.left + bar.right) / 2;
  const double expected = marking_width_px / 2;
  // Colour is blurred more than brightness, and what is bright beside the paint widens it.
  constexpr double kUnlike = 0.25;
  const double half =
      bar.right - bar.left > kSharp
          ? std::clamp((bar.right - bar.left) / 2, (1 - kUnlike) * expected, (1 + kUnlike) * expected)
          : expected;
  return side == Side::left ? middle + half : middle - half;
}

bool is_of(const PaintBar& bar, MarkingColour colour) {
  return bar.yellow == (colour == MarkingColour::yellow);
}

bool has_colour(std::span<const PaintBar> bars, MarkingColour colour) {
  return colour != MarkingColour::unknown &&
         std::any_of(bars.begin(), bars.end(), [&](const PaintBar& bar) { return is_of(bar, colour); });
}

}  // namespace

bool is_hidden(std::span<const VehicleBox> vehicles, double column, double row) {
  constexpr double kAround = 3;  // [px]
  return std::any_of(vehicles.begin(), vehicles.end(), [&](const VehicleBox& box) {
    return row > box.top - kAround && row < box.bottom + kAround && column > box.left - kAround &&
           column < box.right + kAround;
  });
}

void EdgeSearch::search(const EdgeScene& scene, const LaneFilter& filter) {
  window_count_ = 0;
  edge_count_ = 0;
  search_side(scene, filter, Side::left);
  search_side(scene, filter, Side::right);
}

void EdgeSearch::search_side(const EdgeScene& scene, const LaneFilter& filter, Side side) {
  const LaneState::Vector& state = filter.state().mean;
  const Clothoid edge = LaneState::edge(state, side);
  const double pitch = state[LaneState::kPitch];
  const double bend = state[LaneState::kVerticalCurvature];
  const auto pixel_at = [&](double x) { return scene.sight->pixel({x, edge.y(x)}, pitch, bend); };
  int last_row = scene.image.height;
  for (double x = config_.nearest; x <= config_.farthest; x *= config_.spacing) {
    const auto here = pixel_at(x);
    const auto beyond = pixel_at(1.02 * x);
    // Behind a crest the road turns back down the image.
    if (!here || !beyond || !(beyond->y() < here->y() - 0.01)) break;
    const int row = static_cast<int>(std::lround(here->y()));
    if (row >= last_row) continue;
    const double slant = (beyond->x() - here->x()) / (beyond->y() - here->y());
    const double column = here->x() + (row - here->y()) * slant;
    if (row < 0 || !(column > 0) || !(column < scene.image.width - 1)) continue;
    const auto expected = edge_residual(*scene.sight, scene.sight->ray({column, row}), side, state);
    if (!expected) continue;
    last_row = row;
    const double variance = expected->jacobian * filter.state().covariance * expected->jacobian.transpose() +
                            filter.noise(*expected);
    const double half = std::min(config_.gate * std::sqrt(variance) + 1,
                                 kWidestPart * state[LaneState::kWidth] / expected->metres_per_pixel);
    SearchedWindow window;
    window.side = side;
    window.distance = expected->distance;
    window.row = row;
    window.left = column - half;
    window.right = column + half;
    window.metres_per_pixel = expected->metres_per_pixel;
    window.hidden = is_hidden(scene.vehicles, column, row);
    search_window(scene, window, slant);
    if (window_count_ == windows_.size() || edge_count_ == edges_.size()) return;
  }
}

void EdgeSearch::search_window(const EdgeScene& scene, SearchedWindow window, double slant) {
  BarQuery query;
  query.row = static_cast<int>(window.row);
  // One row shows a stretch of the road, on which a slanted marking moves sideways.
  query.narrowest = std::max(1.0, config_.marking_width_min / window.metres_per_pixel - 1);
  query.widest = config_.marking_width_max / window.metres_per_pixel + 2 + std::abs(slant);
  query.contrast = config_.contrast_min;
  const double bar = std::min(query.widest, 0.4 / window.metres_per_pixel + 3);
  query.left = static_cast<int>(std::floor(window.left - (window.side == Side::left ? bar : 2)));
  query.right = static_cast<int>(std::ceil(window.right + (window.side == Side::left ? 2 : bar)));
  query.left = std::max(query.left, 0);
  query.right = std::min(query.right, scene.image.width - 1);
  const int number = static_cast<int>(window_count_);
  window.first_edge = static_cast<int>(edge_count_);
  const double marking_width =
      scene.marking_widths[window.side == Side::left ? 0 : 1] / window.metres_per_pixel;
  if (!window.hidden && query.left < query.right) {
    const std::span<const PaintBar> bars = finder_.find(scene.image, query);
    const MarkingColour colour = scene.colours[window.side == Side::left ? 0 : 1];
    const bool choosy = has_colour(bars, colour);
    for (const PaintBar& found : bars) {
      if (choosy && !is_of(found, colour)) continue;
      const double column = inner_edge(found, window.side, marking_width);
      if (column < window.left || column > window.right) continue;
      if (is_hidden(scene.vehicles, column, window.row)) continue;
      if (edge_count_ == edges_.size()) break;
      EdgeMeasurement& edge = edges_[edge_count_];
      edge.ray = scene.sight->ray({column, window.row});
      edge.side = window.side;
      edge.window = number;
      edge.column = column;
      edge.row = window.row;
      edge.confidence = std::clamp(found.contrast / 25, 0.3, 1.0);
      bars_[edge_count_++] = found;
      ++window.edge_count;
    }
  }
  windows_[window_count_++] = window;
}

}  // namespace lanefuse
