// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lanefuse {

/// `lanefuse benchmark cameras`: renders drives and judges what the cameras saw, image by image.
struct CameraBenchmarkOptions {
  std::vector<std::string> conditions{"clear", "low-sun", "wet", "night"};
  std::string road = "gentle";
  std::string seeds = "1";
  double km = 0.5;
  bool objects = true;
  std::size_t jobs = 0;  ///< at a time; 0: one a core
  bool json = false;
  bool force = false;
};

int benchmark_cameras(const CameraBenchmarkOptions& options);

}  // namespace lanefuse
