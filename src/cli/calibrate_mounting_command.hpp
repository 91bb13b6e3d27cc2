// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace lanefuse {

/// `lanefuse calibrate mounting IMAGES... --camera FILE --lane-width-m W`: how it stands, from straight
/// roads.
struct CalibrateMountingOptions {
  std::vector<std::filesystem::path> images;
  std::filesystem::path camera;
  double lane_width = 3.5;                      ///< [m] between the middles of the markings
  std::optional<std::filesystem::path> output;  ///< camera.yaml
  bool json = false;
  bool force = false;
};

int calibrate_mounting(const CalibrateMountingOptions& options);

}  // namespace lanefuse
