// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pipeline/settings_section.hpp"
#include "road/road_config.hpp"

namespace lanefuse {

/// The settings of the road-level estimator.
void add_road_settings(const Section& s, RoadConfig& c);

}  // namespace lanefuse
