// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmark/coverage.hpp"

namespace lanefuse {

/// A table a row of drives, every 20 m, with a verdict at each distance; for a terminal or as Markdown.
std::string to_text(const std::vector<Coverage>& all, bool markdown);
/// The same at every 10 m, with the confidence intervals' ends.
nlohmann::ordered_json to_json(const std::vector<Coverage>& all);

}  // namespace lanefuse
