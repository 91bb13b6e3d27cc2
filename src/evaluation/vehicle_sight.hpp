// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sensors/truth.hpp"

namespace lanefuse {

/// Which share, in [0, 1], of each vehicle's angular width is in sight of the car's origin, past the vehicles
/// that are nearer; in the order of the frame's objects. Seen from above: nobody looks over or under anybody.
std::vector<double> shares_in_sight(const TrueFrame& frame);

}  // namespace lanefuse
