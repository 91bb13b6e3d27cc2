// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace lanefuse {

/// What the command line asks for. CLI11 stays behind this: it costs half a minute to compile.
///
/// Wrong use prints its reason to standard error and gives an action that returns 2; --help and --version
/// print and give one that returns 0.
std::function<int()> parse_arguments(int argc, char** argv);

}  // namespace lanefuse
