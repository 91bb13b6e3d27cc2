// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace lanefuse {

/// `lanefuse map build DRIVE... -o MAP`: surveys a road from several drives.
struct MapBuildOptions {
  std::vector<std::filesystem::path> drives;
  std::filesystem::path output;
  std::optional<std::filesystem::path> against;  ///< a drive's exact road, or a map, to compare with
  std::optional<std::filesystem::path> chart;    ///< of the error along the road (.svg); needs `against`
  bool json = false;
  bool force = false;
};

int map_build(const MapBuildOptions& options);

/// `lanefuse map compare MAP --truth MAP|DRIVE`: how far a map's lines lie from the true ones.
struct MapCompareOptions {
  std::filesystem::path map;
  std::filesystem::path truth;
  std::optional<std::filesystem::path> chart;
  bool json = false;
  bool force = false;
};

int map_compare(const MapCompareOptions& options);

}  // namespace lanefuse
