// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/estimator_choice.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

struct Choice {
  std::string_view name;
  EstimatorKind kind;
  RoadAssociation association;
};

constexpr std::array<Choice, 3> kChoices{{
    {"graph", EstimatorKind::graph, RoadAssociation::gated},
    {"road", EstimatorKind::road, RoadAssociation::gated},
    {kOracle, EstimatorKind::road, RoadAssociation::labelled},
}};

}  // namespace

std::vector<std::string> estimator_names() {
  std::vector<std::string> names;
  std::transform(kChoices.begin(), kChoices.end(), std::back_inserter(names),
                 [](const Choice& choice) { return std::string(choice.name); });
  return names;
}

void choose_estimator(PerceptionConfig& config, std::string_view name) {
  const auto found = std::find_if(kChoices.begin(), kChoices.end(),
                                  [name](const Choice& choice) { return choice.name == name; });
  if (found == kChoices.end()) {
    throw configuration_error("--estimator", fmt::format("there is no '{}'", name),
                              fmt::format("choose among {}", fmt::join(estimator_names(), ", ")));
  }
  config.estimator = found->kind;
  config.road.association = found->association;
}

}  // namespace lanefuse
