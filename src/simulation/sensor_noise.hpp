// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/preset.hpp"

namespace lanefuse {

/// How much more, or less, than they say sensors may be made to err.
inline constexpr Range kNoiseFactors{0.01, 100};

/// The preset with every sensor's errors `factor` times as large: the sigmas of pixels, of how cameras stand
/// (pitch, yaw), of errors that a frame shares, of detections and objects, of misalignments, of odometry and
/// GNSS. What sensors state of their errors stays the preset's own, so that whoever believes them is
/// mis-tuned. Rates, ranges, latencies, chances of detection, clutter, the road and the drivers stay, too.
///
/// The preset's hash then names the factor. Throws a configuration Error for a factor beyond kNoiseFactors.
SensorPreset with_noise(const SensorPreset& preset, double factor);

}  // namespace lanefuse
