// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluation/tracking_figures.hpp"

namespace lanefuse {

/// As in docs/evaluation.md; what is not known is null.
nlohmann::ordered_json to_json(const TrackingFigures& figures);

}  // namespace lanefuse
