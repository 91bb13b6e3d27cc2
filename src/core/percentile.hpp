// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace lanefuse {

/// The value that `share` of `values` do not exceed, by nearest rank; share in (0, 1]. 0 for no values.
double percentile(std::vector<double> values, double share);

}  // namespace lanefuse
