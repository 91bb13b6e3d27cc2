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
/// Table I's columns and more, by distance.
std::string deviation_table(const EvaluationResult& result);
/// What the words in the tables mean.
std::string report_glossary(const EvaluationResult& result);

}  // namespace lanefuse
