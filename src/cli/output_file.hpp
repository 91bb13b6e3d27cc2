// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace lanefuse {

/// Refuses, with a configuration Error, an output that is there already (unless `force`), that is one of the
/// inputs, or whose folder is not there. Called before any work is done.
void check_output(const std::filesystem::path& output, bool force, const std::filesystem::path& input = {});

/// Writes a text file whole or not at all.
void write_text(const std::filesystem::path& output, const std::string& text);

}  // namespace lanefuse
