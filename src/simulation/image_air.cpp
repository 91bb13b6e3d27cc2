// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_air.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {

float air_transmission(double distance, const ImageLight& light) {
  return static_cast<float>(std::exp(-3.9 * distance / light.visibility));  // Koschmieder: 2 % are left
}

LinearColour through_air(const LinearColour& thing, double distance, const ImageLight& light) {
  return light.horizon + air_transmission(distance, light) * (thing - light.horizon);
}

/// Dipped beams, a little further on the right: a fit to what such a beam shows, not a lamp's data sheet.
float headlights_on_road(double x, double y) {
  if (x < 1) return 0;
  const double to_the_right = std::clamp(-y / (0.05 * x + 2), -1.0, 1.0);
  const double reach = 36 + 8 * to_the_right;
  const double along =
      (1 - std::exp(-x / 7)) * std::exp(-(x / reach) * (x / reach)) + 0.03 * std::exp(-x / 70);
  const double width = 3 + 0.16 * x;
  return static_cast<float>(1.1 * along * std::exp(-(y / width) * (y / width)));
}

float headlights_upright(double x, double y) {
  if (x < 1) return 0;
  const double width = 4 + 0.16 * x;
  return static_cast<float>(0.5 * std::exp(-x / 40) * std::exp(-(y / width) * (y / width)));
}

LinearColour light_on_road(double x, double y, const ImageLight& light) {
  LinearColour all = light.ambient + light.sun;
  if (light.headlights) all += headlights_on_road(x, y) * colour(0.85F, 0.97F, 1);
  return all;
}

LinearColour light_upright(double x, double y, const ImageLight& light) {
  LinearColour all = 0.6F * light.ambient + 0.35F * light.sun;
  if (light.headlights) all += headlights_upright(x, y) * colour(0.85F, 0.97F, 1);
  return all;
}

}  // namespace lanefuse
