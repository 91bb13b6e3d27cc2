// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pipeline/settings_section.hpp"
#include "sources/camera_images.hpp"
#include "sources/lane_segmentation_source.hpp"

namespace lanefuse {

/// The settings of cameras that hand over images.
void add_images(const Section& section, CameraImagesConfig& config);

/// The settings of the user's own lane segmentation.
void add_lane_segmentation(const Section& section, LaneSegmentationSourceConfig& config);

}  // namespace lanefuse
