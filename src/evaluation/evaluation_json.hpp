// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// The result as JSON: `lanes{ego[],adjacent[]}`, the rates and counts, and whatever else this truth gives
/// (`baselines` for the ego path; `consistency`, `by_vehicles_ahead`, `by_gap_ahead`, `serial_camera`,
/// `surveyed` for a road). What is not known is null.
nlohmann::ordered_json to_json(const EvaluationResult& result);

}  // namespace lanefuse
