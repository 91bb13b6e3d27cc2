// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace lanefuse {

/// `lanefuse map info FILE`: what a map holds.
struct MapInfoOptions {
  std::filesystem::path map;
  bool json = false;
  bool force = false;
};

int map_info(const MapInfoOptions& options);

/// `lanefuse map convert IN -o OUT`: a map in another format.
struct MapConvertOptions {
  std::filesystem::path map;
  std::filesystem::path output;
  std::string origin;  ///< "LAT,LON" in degrees, over the map's own; may be empty
  bool json = false;
  bool force = false;
};

int map_convert(const MapConvertOptions& options);

}  // namespace lanefuse
