// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config.hpp"

namespace lanefuse {

/// What a benchmark can fuse with, as DriveKey::estimator names it; the first is the paper's.
std::vector<std::string> estimator_names();

/// Sets the pipeline to the estimator of that name. Throws a configuration Error that lists the names there
/// are.
void choose_estimator(PerceptionConfig& config, std::string_view name);

}  // namespace lanefuse
