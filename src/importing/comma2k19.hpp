// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// A drive of a public data set in the project's own terms.
struct ImportedDrive {
  DriveInfo info;
  Rig rig;
  std::vector<Measurement> measurements;  ///< in the order in which they were received
  std::vector<TrueFrame> truth;           ///< in order of time
  std::vector<std::string> notes;         ///< what was assumed and what was left out, for the user to read
};

/// The ids of the sensors in an imported comma2k19 drive.
inline constexpr std::uint32_t kCommaOdometry = 0;
inline constexpr std::uint32_t kCommaRadar = 1;

/// Imports one minute of comma2k19 (Toyota RAV4 or Honda Civic): speed, wheel speeds and radar from the CAN
/// bus, yaw rate from the windscreen device's gyro, and its poses as truth, never as input. `directory` is a
/// segment or holds exactly one. Time is the recording device's, since its boot. What is known of the sensors
/// is in docs/comma2k19.md.
///
/// Throws Error naming file and row for arrays that are missing, do not fit together or are not believable.
ImportedDrive import_comma2k19(const std::filesystem::path& directory);

}  // namespace lanefuse
