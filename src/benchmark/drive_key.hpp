// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace lanefuse {

/// What is driven, and how it is fused and judged: names one drive of a benchmark, and its line in a file of
/// results.
struct DriveKey {
  std::string scene = "nominal";
  std::string road = "gentle";
  std::uint64_t seed = 1;
  double km = 24;
  std::string variant = "full";
  std::string estimator = "graph";
  std::string truth = "exact";
  double noise = 1;  ///< sensors err so many times as much as they say: see with_noise()
  friend auto operator<=>(const DriveKey&, const DriveKey&) = default;
};

/// For people: "nominal, gentle, seed 1, 24 km, full, graph, truth exact".
std::string to_string(const DriveKey& key);
/// ", noise x 2"; nothing for 1.
std::string noise_in_name(double noise);

}  // namespace lanefuse
