// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace lanefuse {

/// The cells of one line of a table, in UTF-8.
using TextRow = std::vector<std::string>;

/// Columns under a head (the first row), aligned for a terminal or as Markdown. All rows are equally long.
std::string text_grid(const std::vector<TextRow>& rows, bool markdown);

}  // namespace lanefuse
