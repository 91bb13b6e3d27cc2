// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/image_light.hpp"

namespace lanefuse {

/// Share of a thing's light that comes through `distance` [m] of the air.
float air_transmission(double distance, const ImageLight& light);

/// The colour of a thing `distance` [m] away, with the air's own light.
LinearColour through_air(const LinearColour& thing, double distance, const ImageLight& light);

/// Light of the own headlights on the road at a place ahead (x, y) [m], and on what stands upright there.
float headlights_on_road(double x, double y);
float headlights_upright(double x, double y);

/// Irradiance of a level place, and of an upright face towards the camera, out of the shade.
LinearColour light_on_road(double x, double y, const ImageLight& light);
LinearColour light_upright(double x, double y, const ImageLight& light);

}  // namespace lanefuse
