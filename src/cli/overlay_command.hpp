// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lanefuse {

/// `lanefuse overlay LANES -o VIDEO.mp4`: the images of a drive with what was seen in them and the lanes that
/// were estimated; with --at one picture.
struct OverlayOptions {
  std::filesystem::path lanes;
  std::optional<std::filesystem::path> drive;  ///< with the images; else the one that the run names
  std::optional<std::string> camera;           ///< by name; else the first that hands over images
  std::optional<double> from;                  ///< [s] since the first cycle
  std::optional<double> to;                    ///< [s] since the first cycle
  std::optional<double> at;                    ///< [s] since the first cycle
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int overlay(const OverlayOptions& options);

}  // namespace lanefuse
