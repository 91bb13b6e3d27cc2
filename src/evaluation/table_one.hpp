// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// One row of the paper's Table I [IROS16, table I]: all in metres, against the paper's own map.
struct PaperFigures {
  double mean = 0;
  double sigma = 0;
  double rmse = 0;
};
struct PaperRow {
  double distance = 0;
  PaperFigures ego;
  PaperFigures adjacent;
};
inline constexpr std::array kTableOne{PaperRow{0, {0.00, 0.10, 0.10}, {-0.04, 0.20, 0.21}},
                                      PaperRow{20, {-0.02, 0.10, 0.11}, {-0.07, 0.20, 0.21}},
                                      PaperRow{40, {-0.06, 0.17, 0.18}, {-0.11, 0.25, 0.27}},
                                      PaperRow{60, {-0.11, 0.26, 0.28}, {-0.17, 0.32, 0.37}},
                                      PaperRow{80, {-0.20, 0.38, 0.42}, {-0.24, 0.44, 0.50}},
                                      PaperRow{100, {-0.26, 0.48, 0.55}, {-0.29, 0.59, 0.66}},
                                      PaperRow{120, {-0.26, 0.58, 0.64}, {-0.47, 0.87, 0.99}}};

/// How an RMSE stands to the paper's: alike is within 35 % up to 80 m and within a factor of 2 beyond. What
/// is better by more calls for an explanation as much as what is worse: the sensors may be too kind.
enum class AgainstPaper : std::uint8_t { not_judged, alike, worse, better };

struct PaperComparison {
  double distance_m = 0;
  bool ego = true;  ///< else adjacent
  DeviationStatistics ours;
  PaperFigures paper;
  double ratio = 0;  ///< ours by the paper's; NaN where nothing was judged
  AgainstPaper verdict = AgainstPaper::not_judged;
};

/// One entry a figure of Table I, by distance, ego before adjacent; empty where the result has no lanes.
std::vector<PaperComparison> compare_with_table_one(const LaneStatistics& lanes);

}  // namespace lanefuse
