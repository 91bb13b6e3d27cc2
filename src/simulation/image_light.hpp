// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "simulation/image_conditions.hpp"

namespace lanefuse {

/// Blue, green, red and one number more, in linear light: 1 saturates the chip at an exposure of 1.
using LinearColour = Eigen::Array4f;
inline LinearColour colour(float blue, float green, float red) { return {blue, green, red, 0}; }
inline LinearColour grey(float value) { return {value, value, value, 0}; }

/// The light and the air of the conditions, and what the weather does to surfaces.
struct ImageLight {
  LinearColour sky = grey(0.5F);      ///< high over the horizon
  LinearColour horizon = grey(0.7F);  ///< the sky at the horizon, and the air's own light in the distance
  LinearColour ambient = grey(0.5F);  ///< irradiance of the sky on level ground
  LinearColour sun = grey(1);         ///< irradiance of the sun on level ground
  double sun_azimuth = 0;             ///< [rad] in the world, from its x axis
  double sun_height = 0.8;            ///< [rad] over the horizon
  double visibility = 10'000;         ///< [m] at which contrast falls to 2 %
  float asphalt = 0.13F;              ///< albedo
  float paint = 0.62F;                ///< albedo of white paint
  float mirror = 0;                   ///< share of the sky that the road mirrors at a grazing view
  float glare = 0;                    ///< light scattered in the windscreen
  float exposure = 1;
  float noise = 0.006F;  ///< sigma of the chip, in the root of its range
  bool headlights = false;
};

ImageLight image_light(ImageConditions conditions);

}  // namespace lanefuse
