// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace lanefuse {

/// `lanefuse simulate --commonroad`: records the drive of a recorded vehicle among the others.
struct ReplayOptions {
  std::filesystem::path scenario;   ///< CommonRoad XML
  std::optional<std::int64_t> ego;  ///< id of the ego car; else who was recorded longest
  bool list = false;                ///< only say which vehicles there are
  std::uint64_t seed = 1;
  bool detections = false;                ///< instead of the object list
  std::optional<int> guard_rail_mirrors;  ///< most a scan; else the preset's
  std::filesystem::path output;
  bool json = false;
  bool force = false;
};

int replay(const ReplayOptions& options);

}  // namespace lanefuse
