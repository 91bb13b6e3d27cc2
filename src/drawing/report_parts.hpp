// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "drawing/report.hpp"

/// The parts of the report's page, each as HTML. See write_report().
namespace lanefuse {

std::string report_css();
std::string title_of(const Report& report);
/// Title, drive, witness rule and verdict.
std::string report_header(const Report& report);
/// Counts and times of the run, a tile each.
std::string report_figures(const Report& report);
/// Table I as the paper prints it, with the paper's figures and the ratio of the RMSE beside ours; below it,
/// in words, where they differ by more than they may. Empty where the truth is no road.
std::string paper_section(const EvaluationResult& result);
/// The serial camera alone, where it was judged.
std::string camera_section(const EvaluationResult& result);
/// Error against traffic and against the vehicle ahead, where the truth is a road.
std::string traffic_section(const EvaluationResult& result);
/// The vehicles around, where they were tracked.
std::string tracking_section(const EvaluationResult& result);
/// The drive, and the moments that know their place, on the map.
std::string map_section(const Report& report);
/// Table I's columns and more, by distance.
std::string deviation_table(const EvaluationResult& result);
/// What the estimate says of its own error, by distance; empty where the truth is no road.
std::string uncertainty_table(const EvaluationResult& result);
/// What the words in the tables mean.
std::string report_glossary(const EvaluationResult& result);

}  // namespace lanefuse
