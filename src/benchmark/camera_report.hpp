// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "benchmark/camera_trial.hpp"

namespace lanefuse {

/// The figures of cameras under one kind of conditions, for programs.
nlohmann::ordered_json to_json(const CameraTrialFigures& figures);

/// The same for people: tables in Markdown.
std::string to_text(const CameraTrialFigures& figures);

}  // namespace lanefuse
