// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sensors/rig.hpp"

namespace lanefuse {

/// `lanefuse calibrate chessboard IMAGES...`: a camera's lens from pictures of a chessboard.
struct CalibrateChessboardOptions {
  std::vector<std::filesystem::path> images;
  std::string pattern = "9x6";   ///< inner corners
  std::optional<double> square;  ///< [m] side of a square: then the boards' distances are told, too
  std::string name = "front";    ///< of the camera in the file
  SensorKind kind = SensorKind::camera;
  std::optional<std::filesystem::path> output;  ///< camera.yaml
  bool json = false;
  bool force = false;
};

int calibrate_chessboard(const CalibrateChessboardOptions& options);

}  // namespace lanefuse
