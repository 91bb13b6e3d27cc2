// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "drawing/chart.hpp"
#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// RMSE by distance: against exact truth for ego and adjacent lanes beside the paper's Table I, against the
/// ego path for the lane's centre beside the baselines.
Chart rmse_chart(const EvaluationResult& result);

/// Mean of the deviation by distance, between lines of one sigma.
Chart bias_chart(const EvaluationResult& result);

/// Share of the cycles in which each distance was reached [%].
Chart availability_chart(const EvaluationResult& result);

}  // namespace lanefuse
