// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "drawing/svg.hpp"

namespace lanefuse {

/// The line with as few of its points as keep it within `tolerance` [px] of all of them (Douglas and Peucker,
/// 1973); the first and the last one stay. All points must be finite.
std::vector<Pixel> thinned_line(const std::vector<Pixel>& points, double tolerance);

}  // namespace lanefuse
