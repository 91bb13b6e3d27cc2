// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "camera/ground_projection.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// Where in the image a tracked vehicle stands: the box around its rear, as high as vehicles of its length
/// are. Nothing where its rear is not ahead of the camera.
std::optional<VehicleBox> vehicle_region(const TrackedObject& object, const GroundProjection& projection);

}  // namespace lanefuse
