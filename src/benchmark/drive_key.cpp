// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/drive_key.hpp"

#include <fmt/format.h>

namespace lanefuse {

std::string noise_in_name(double noise) { return noise == 1 ? "" : fmt::format(", noise x {}", noise); }

std::string to_string(const DriveKey& key) {
  return fmt::format("{}, {}, seed {}, {} km, {}, {}, truth {}{}", key.scene, key.road, key.seed, key.km,
                     key.variant, key.estimator, key.truth, noise_in_name(key.noise));
}

}  // namespace lanefuse
