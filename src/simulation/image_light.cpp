// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_light.hpp"

namespace lanefuse {
namespace {

ImageLight clear_day() {
  ImageLight light;
  light.sky = colour(0.95F, 0.60F, 0.36F);
  light.horizon = colour(1.0F, 0.88F, 0.76F);
  light.ambient = colour(0.52F, 0.42F, 0.36F);
  light.sun = colour(0.95F, 1.05F, 1.12F);
  light.sun_azimuth = 2.2;
  light.sun_height = 0.75;
  light.visibility = 9000;
  light.exposure = 0.85F;
  return light;
}

ImageLight low_sun() {
  ImageLight light;
  light.sky = colour(0.80F, 0.66F, 0.58F);
  light.horizon = colour(0.95F, 1.25F, 1.55F);
  light.ambient = colour(0.40F, 0.38F, 0.38F);
  light.sun = colour(0.16F, 0.25F, 0.36F);
  light.sun_azimuth = 0.15;
  light.sun_height = 0.16;
  light.visibility = 2500;
  light.mirror = 0.3F;
  light.glare = 0.10F;
  light.exposure = 0.9F;
  return light;
}

ImageLight wet_day() {
  ImageLight light;
  light.sky = grey(0.52F);
  light.horizon = colour(0.74F, 0.72F, 0.70F);
  light.ambient = colour(0.72F, 0.69F, 0.66F);
  light.sun = grey(0);
  light.visibility = 900;
  light.asphalt = 0.055F;
  light.paint = 0.36F;
  light.mirror = 0.55F;
  light.glare = 0.02F;
  light.exposure = 0.85F;
  light.noise = 0.008F;
  return light;
}

ImageLight at_night() {
  ImageLight light;
  light.sky = colour(0.012F, 0.009F, 0.008F);
  light.horizon = colour(0.018F, 0.017F, 0.018F);
  light.ambient = colour(0.012F, 0.011F, 0.011F);
  light.sun = grey(0);
  light.visibility = 6000;
  light.paint = 1.6F;  // glass beads throw the headlights' light back
  light.exposure = 1;
  light.noise = 0.018F;
  light.headlights = true;
  return light;
}

}  // namespace

ImageLight image_light(ImageConditions conditions) {
  switch (conditions) {
    case ImageConditions::low_sun:
      return low_sun();
    case ImageConditions::wet:
      return wet_day();
    case ImageConditions::night:
      return at_night();
    case ImageConditions::clear:
      break;
  }
  return clear_day();
}

}  // namespace lanefuse
