// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/feature.hpp"

namespace lanefuse {

/// Appends features every `spacing` metres along a tracked clothoid, with the covariance that the clothoid's
/// own has there [IROS16, sec. II-E2]. Their confidence is the clothoid's, falling with distance as exp(-x /
/// 60 m).
void sample_clothoid(const ClothoidMeasurement& measurement, double spacing, std::vector<Feature>& features);

}  // namespace lanefuse
