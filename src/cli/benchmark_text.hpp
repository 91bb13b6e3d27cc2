// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmark/comparison.hpp"
#include "benchmark/summary.hpp"

namespace lanefuse {

/// Rows of means with their 95 % intervals, beside the paper's Table I where a row is nominal; for a terminal
/// or as Markdown.
std::string to_text(const std::vector<Summary>& summaries, bool markdown);
nlohmann::ordered_json to_json(const std::vector<Summary>& summaries);

/// BenchmarkFigure by figure what changed, and whether it may be chance.
std::string to_text(const Comparison& comparison);
nlohmann::ordered_json to_json(const Comparison& comparison);

}  // namespace lanefuse
