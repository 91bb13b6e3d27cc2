// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/bright_bars.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

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

/// Where within a pixel a parabola through three steps has its extremum.
double vertex_of(const Signal& steps, std::size_t u) {
  const double before = steps[u - 1];
  const double here = steps[u];
  const double after = steps[u + 1];
  const double bend = before - 2 * here + after;
  return static_cast<double>(u) + (bend == 0 ? 0 : std::clamp(0.5 * (before - after) / bend, -0.5, 0.5));
}

/// A step up and the next step down make a bar.
void pair_steps(const Signal& steps, int row, int contrast, std::vector<BrightBar>& bars) {
  const double widest = static_cast<double>(steps.size()) / 16;
  std::optional<double> up;
  for (std::size_t u = kReach; u + kReach < steps.size(); ++u) {
    const int here = steps[u];
    if (here >= contrast && here >= steps[u - 1] && here > steps[u + 1]) {
      up = vertex_of(steps, u);
    } else if (here <= -contrast && here <= steps[u - 1] && here < steps[u + 1] && up) {
      const double down = vertex_of(steps, u);
      if (down - *up <= widest) bars.push_back({row, *up, down});
      up.reset();
    }
  }
}

}  // namespace

std::vector<BrightBar> find_bright_bars(const ImageView& image, int contrast) {
  std::vector<BrightBar> bars;
  if (image.width <= 2 * kReach) return bars;
  Signal signal(static_cast<std::size_t>(image.width));
  Signal steps(signal.size());
  for (int v = image.height * 2 / 5; v < image.height; ++v) {
    brightness_of(image, v, signal);
    steps_of(signal, steps);
    pair_steps(steps, v, contrast, bars);
    if (image.channels != 3) continue;
    yellowness_of(image, v, signal);
    steps_of(signal, steps);
    pair_steps(steps, v, contrast, bars);
  }
  return bars;
}

}  // namespace lanefuse
