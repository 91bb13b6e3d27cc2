// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "graph/solver.hpp"

namespace lanefuse {

const char* to_string(SolveStatus status) {
  switch (status) {
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::iterations_exhausted:
      return "iterations_exhausted";
    case SolveStatus::singular:
      return "singular";
    case SolveStatus::not_finite:
      return "not_finite";
    case SolveStatus::no_fixed_vertex:
      return "no_fixed_vertex";
    case SolveStatus::bad_edge:
      return "bad_edge";
  }
  return "unknown";
}

const char* to_string(SolveFallback fallback) {
  switch (fallback) {
    case SolveFallback::none:
      return "none";
    case SolveFallback::not_a_window:
      return "not_a_window";
    case SolveFallback::cg_struggled:
      return "cg_struggled";
    case SolveFallback::negative_curvature:
      return "negative_curvature";
  }
  return "unknown";
}

}  // namespace lanefuse
