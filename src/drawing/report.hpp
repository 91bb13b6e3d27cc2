// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/top_view.hpp"
#include "evaluation/error_trace.hpp"
#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// What the run itself cost and took in; what is not known is not told.
struct RunFigures {
  std::optional<double> duration_s;  ///< of the drive
  std::optional<InputAccounting> inputs;
  std::optional<GraphSize> largest_graph;
  std::vector<double> cycle_ms;  ///< wall-clock time of each cycle
};

/// A picture of one moment with what there is to see in it.
struct Moment {
  TopView view;
  std::string caption;
  std::optional<Pose2> world_from_vehicle;  ///< with it, the moment is shown on the map too
};

struct Report {
  std::string title;
  EvaluationResult evaluation;  ///< with the drive's name and its witness rule
  RunFigures run;
  std::vector<Moment> moments;
  ErrorTrace trace;  ///< of the whole drive; empty: no picture of it
};

/// The whole report as one HTML page that needs nothing from outside of itself.
std::string write_report(const Report& report);

/// The result in a sentence or two, with the figures that matter; plain text.
std::string verdict(const EvaluationResult& result);

}  // namespace lanefuse
