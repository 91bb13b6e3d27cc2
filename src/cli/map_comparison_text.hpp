// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "roadmap/map_comparison.hpp"

namespace lanefuse {

nlohmann::ordered_json to_json(const MapComparison& comparison);
std::string to_table(const MapComparison& comparison);

/// The deviation of every line along the road, as a picture (SVG).
std::string to_chart(const MapComparison& comparison);

}  // namespace lanefuse
