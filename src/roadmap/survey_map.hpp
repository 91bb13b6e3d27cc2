// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "roadmap/road_map.hpp"
#include "roadmap/survey_config.hpp"
#include "roadmap/survey_drive.hpp"

namespace lanefuse {

/// Merges drives, each on a lane of one road, into a map of its marking lines [IROS16, sec. III]: the
/// evaluation's ground truth. `origin` is that of the frame that the drives were recorded in.
///
/// The map reaches as far as the longest drive; what others saw beyond it is left out. Throws Error (input)
/// where there is no drive, or nothing that two drives or two lanes could be tied by.
RoadMap survey_map(std::span<const SurveyedDrive> drives, const GeoOrigin& origin,
                   const SurveyConfig& config = {});

}  // namespace lanefuse
