// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cli/evaluate_command.hpp"
#include "cli/evaluate_highlights.hpp"
#include "cli/lanes_and_truth.hpp"
#include "evaluation/error_trace.hpp"
#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

struct Judged {
  EvaluationResult result;
  ErrorTrace trace;  ///< only against a road
  std::vector<Highlight> highlights;
};

/// Reads the lanes once and judges every cycle by the truth that was asked for. Throws Error (input) where
/// the lanes or the drive are damaged, or hold no truth of that kind. With a map, its road is in `context`.
Judged judge_lanes(const EvaluateOptions& options, const LanesAndTruth& context);

/// Throws Error (input) where a file could not be read to its end.
void refuse_damage(const std::filesystem::path& file, const ReadReport& report);

}  // namespace lanefuse
