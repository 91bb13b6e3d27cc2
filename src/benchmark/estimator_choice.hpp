// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config.hpp"

namespace lanefuse {

/// What the oracle is called: the road-level estimator that is told which line each measurement truly is of.
/// It shows what the data would permit. Only a benchmark has it, for nothing that drives is told.
inline constexpr std::string_view kOracle = "oracle";

/// What a benchmark can fuse with: graph, road, oracle.
std::vector<std::string> estimator_names();

/// Lets the pipeline fuse with the estimator of that name, whatever it fused with before. Throws a
/// configuration Error that lists the names there are.
void choose_estimator(PerceptionConfig& config, std::string_view name);

}  // namespace lanefuse
