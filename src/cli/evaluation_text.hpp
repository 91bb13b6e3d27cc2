// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "evaluation/evaluation_result.hpp"

namespace lanefuse {

/// The result as a table for a terminal, with Table I's columns.
std::string to_table(const EvaluationResult& result);

}  // namespace lanefuse
