// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/estimator_choice.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {

std::vector<std::string> estimator_names() {
  return {to_string(EstimatorKind::graph), to_string(EstimatorKind::road)};
}

void choose_estimator(PerceptionConfig& config, std::string_view name) {
  for (const EstimatorKind kind : {EstimatorKind::graph, EstimatorKind::road}) {
    if (name != to_string(kind)) continue;
    config.estimator = kind;
    return;
  }
  throw configuration_error("--estimator", fmt::format("there is no '{}'", name),
                            fmt::format("choose among {}", fmt::join(estimator_names(), ", ")));
}

}  // namespace lanefuse
