// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "roadmap/survey_config.hpp"
#include "roadmap/survey_trace.hpp"

namespace lanefuse {

/// One line of paint on the road, as all drives saw it.
struct SurveyLine {
  std::vector<std::size_t> traces;  ///< which of the survey's traces saw it
  double paint_width = 0;           ///< [m], measured from both sides, or by the paint's type
  StationSeries lateral;            ///< [m] of the middle of the paint beside the axis, after merge_lines()
};

/// Which traces saw the same line; from left to right.
std::vector<SurveyLine> lines_of(std::span<const SurveyTrace> traces, const SurveyConfig& config);

/// Places each line where its traces agree. A drive's position errs by much the same across a stretch of
/// road, for both of its lane's lines: these errors are found along with the lines, so that lanes tie each
/// other.
void merge_lines(std::span<const SurveyTrace> traces, std::size_t drives, double step,
                 const SurveyConfig& config, std::vector<SurveyLine>& lines);

/// What the line is painted like at every station, by its traces' votes in the neighbourhood.
std::vector<MarkingEvidence> painted(const SurveyLine& line, std::span<const SurveyTrace> traces,
                                     std::size_t reach);

}  // namespace lanefuse
