// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/bright_bars.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <utility>

namespace lanefuse {
namespace {

using Signal = std::vector<int>;

constexpr int kReach = 2;  ///< [px] on either side over which an edge is taken

/// White and yellow paint are both bright in red and green.
void brightness_of(const ImageView& image, int v, Signal& signal) {
  const std::uint8_t* pixel = image.row(v);
  for (int& value : signal) {
    value = image.channels == 3 ? (pixel[1] + pixel[2]) / 2 : pixel[0];
    pixel += image.channels;
  }
}

/// What tells yellow paint from concrete that is as bright.
void yellowness_of(const ImageView& image, int v, Signal& signal) {
  const std::uint8_t* pixel = image.row(v);
  for (int& value : signal) {
    value = std::max(0, std::min(pixel[1], pixel[2]) - pixel[0]);
    pixel += image.channels;
  }
}

/// Steps from left to right, over two pixels on either side.
void steps_of(const Signal& signal, Signal& steps) {
  const int n = static_cast<int>(signal.size());
  const auto at = [&](int u) { return signal[static_cast<std::size_t>(std::clamp(u, 0, n - 1))]; };
  for (int u = 0; u < n; ++u) {
    steps[static_cast<std::size_t>(u)] = (at(u + 1) + at(u + kReach) - at(u - 1) - at(u - kReach)) / 2;
  }
}

/// The least step that is none of the row's own grain.
int least_step(const Signal& steps, int contrast, Signal& sorted) {
  constexpr int kGrains = 5;  // times the median of the steps' sizes, which is two thirds of their sigma
  sorted = steps;
  for (int& step : sorted) step = std::abs(step);
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return std::max(contrast, kGrains * *middle);
}

/// Where within a pixel a parabola through three steps has its extremum.
double vertex_of(const Signal& steps, std::size_t u) {
  const double before = steps[u - 1];
  const double here = steps[u];
  const double after = steps[u + 1];
  const double bend = before - 2 * here + after;
  return static_cast<double>(u) + (bend == 0 ? 0 : std::clamp(0.5 * (before - after) / bend, -0.5, 0.5));
}

/// A step up and the next step down make a bar.
void pair_steps(const Signal& steps, const BrightBar& kind, int contrast, std::vector<BrightBar>& bars) {
  const double widest = static_cast<double>(steps.size()) / 16;
  std::optional<double> up;
  for (std::size_t u = kReach; u + kReach < steps.size(); ++u) {
    const int here = steps[u];
    if (here >= contrast && here >= steps[u - 1] && here > steps[u + 1]) {
      up = vertex_of(steps, u);
    } else if (here <= -contrast && here <= steps[u - 1] && here < steps[u + 1] && up) {
      const double down = vertex_of(steps, u);
      if (down - *up <= widest) bars.push_back({kind.row, *up, down, kind.yellower});
      up.reset();
    }
  }
}

using Chain = std::vector<BrightBar>;

/// Whether a bar carries a chain on: next to its last bars, about as wide, where they lead.
bool continues(const Chain& chain, const BrightBar& bar) {
  constexpr int kLongestGap = 2;   // [px] rows
  constexpr double kFurthest = 3;  // [px]
  constexpr double kWidthChange = 1.6;
  const BrightBar& last = chain.back();
  if (bar.yellower != last.yellower || bar.row == last.row || bar.row - last.row > kLongestGap) return false;
  const double widths = (bar.right - bar.left) / (last.right - last.left);
  if (widths > kWidthChange || widths < 1 / kWidthChange) return false;
  double expected = last.middle();
  if (chain.size() > 4) {
    const BrightBar& earlier = chain[chain.size() - 5];
    expected += (last.middle() - earlier.middle()) / (last.row - earlier.row) * (bar.row - last.row);
  }
  return std::abs(bar.middle() - expected) < kFurthest * (bar.row - last.row);
}

}  // namespace

std::vector<BrightBar> find_bright_bars(const ImageView& image, int contrast) {
  std::vector<BrightBar> bars;
  if (image.width <= 2 * kReach) return bars;
  Signal signal(static_cast<std::size_t>(image.width));
  Signal steps(signal.size());
  Signal sorted(signal.size());
  const auto look = [&](int row, bool yellower) {
    steps_of(signal, steps);
    pair_steps(steps, {row, 0, 0, yellower}, least_step(steps, contrast, sorted), bars);
  };
  for (int v = image.height * 2 / 5; v < image.height; ++v) {
    brightness_of(image, v, signal);
    look(v, false);
    if (image.channels != 3) continue;
    yellowness_of(image, v, signal);
    look(v, true);
  }
  return bars;
}

std::vector<Chain> chain_bars(const std::vector<BrightBar>& bars, std::size_t fewest_rows) {
  std::vector<Chain> done;
  std::vector<Chain> open;
  int row = -1;
  const auto close = [&](const auto& is_over) {
    const auto over =
        std::stable_partition(open.begin(), open.end(), [&](const Chain& c) { return !is_over(c); });
    for (auto chain = over; chain != open.end(); ++chain) {
      if (chain->size() >= fewest_rows) done.push_back(std::move(*chain));
    }
    open.erase(over, open.end());
  };
  for (const BrightBar& bar : bars) {
    if (bar.row != row) close([&](const Chain& chain) { return bar.row - chain.back().row > 2; });
    row = bar.row;
    const auto chain =
        std::find_if(open.begin(), open.end(), [&](const Chain& c) { return continues(c, bar); });
    if (chain == open.end()) {
      open.push_back({bar});
    } else {
      chain->push_back(bar);
    }
  }
  close([](const Chain&) { return true; });
  return done;
}

}  // namespace lanefuse
