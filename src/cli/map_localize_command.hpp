// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace lanefuse {

/// `lanefuse map localize DRIVE --map MAP`: places a drive in a map, by fixes and by markings.
struct MapLocalizeOptions {
  std::filesystem::path drive;
  std::filesystem::path map;
  std::optional<std::filesystem::path> output;  ///< pose by pose (.csv)
  bool json = false;
  bool force = false;
};

int map_localize(const MapLocalizeOptions& options);

}  // namespace lanefuse
