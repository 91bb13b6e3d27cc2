// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drawing/chart.hpp"
#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// RMSE by distance: against a road the paper's own plot, ego red and adjacent blue, with its Table I as
/// dashed lines and the serial camera alone where that was judged; against the ego path for the lane's centre
/// beside the baselines.
Chart rmse_chart(const EvaluationResult& result);

/// Mean of the deviation by distance, between lines of one sigma.
Chart bias_chart(const EvaluationResult& result);

/// Share of the cycles in which each distance was reached [%].
Chart availability_chart(const EvaluationResult& result);

/// Mean normalised square by distance, beside the 1 of an honest sigma. Against a road only.
Chart consistency_chart(const EvaluationResult& result);

/// Share of the deviations inside the interval that should hold 95 % of them. Against a road only.
Chart coverage_chart(const EvaluationResult& result);

/// RMSE at 60 and 120 m over the middle of each condition's ranges, of those ranges that hold enough cycles
/// to say anything; `axis` names the condition, which may be a count of whole things.
Chart condition_chart(const std::string& title, const std::string& axis,
                      const std::vector<ConditionStatistics>& conditions, bool whole_numbers);

/// Lateral RMSE of the tracked vehicles by their distance ahead, at the middle of each range.
Chart tracking_chart(const TrackingFigures& figures);

}  // namespace lanefuse
