// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// The result as a table for a terminal: against a road, Table I's rows and columns with the paper's RMSE and
/// the ratio to it beside.
std::string to_table(const EvaluationResult& result);

}  // namespace lanefuse
