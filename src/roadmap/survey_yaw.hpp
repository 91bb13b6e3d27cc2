// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "roadmap/survey_line.hpp"

namespace lanefuse {

/// By how much a drive's camera looks to the left of where the car heads [rad], at every station: over long
/// stretches the markings that it sees must lie along the lines that were surveyed, near the car and further
/// ahead alike. `input.yaw` is not asked. Calibration and the fixes' heading err together here.
StationSeries camera_yaw(const TraceInput& input, std::span<const SurveyLine> lines, double reach);

}  // namespace lanefuse
