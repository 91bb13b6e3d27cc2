// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/switchable.hpp"

#include <algorithm>

namespace lanefuse {

double best_switch(SwitchForm form, double cost, double prior) {
  if (form == SwitchForm::squared) return prior / (prior + cost);
  return std::clamp(1 - cost / (2 * prior), 0.0, 1.0);
}

double switched_cost(SwitchForm form, double cost, double prior) {
  const double s = best_switch(form, cost, prior);
  return switch_factor(form, s) * cost + prior * (1 - s) * (1 - s);
}

}  // namespace lanefuse
