// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// Where the RMSE is worse or better than Table I's by more than it may be, and what of that the figures
/// themselves explain: bias or scatter, gross errors, the truth's own error, the traffic. Paragraphs of plain
/// text; one that says so where nothing differs.
std::vector<std::string> words_on_table_one(const EvaluationResult& result);

}  // namespace lanefuse
