// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pipeline/settings_section.hpp"
#include "sources/camera_images.hpp"

namespace lanefuse {

/// The settings of cameras that hand over images.
void add_images(const Section& section, CameraImagesConfig& config);

}  // namespace lanefuse
