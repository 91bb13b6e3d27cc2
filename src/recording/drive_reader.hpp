// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "recording/read_report.hpp"
#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"

namespace lanefuse {

/// Replays a recorded drive: what its sensors gave, in the order in which it was received. Whatever truth the
/// file holds is never opened. Memory does not grow with the drive.
class DriveReader {
 public:
  /// Throws Error (input) naming what is wrong: no recorded drive, an unknown version, another frame, a
  /// missing /in/calibration or /in/vehicle_motion, a channel whose sensor is not in the rig.
  explicit DriveReader(const std::filesystem::path& path);
  ~DriveReader();
  DriveReader(DriveReader&&) noexcept;
  DriveReader& operator=(DriveReader&&) noexcept;

  [[nodiscard]] const DriveInfo& info() const;
  [[nodiscard]] const Rig& rig() const;

  /// The next measurement by log time (equal times: as recorded); false at the end. Messages that cannot be
  /// understood are left out and counted in report(). Numbers inside a measurement are not judged.
  bool next(Measurement& measurement);

  [[nodiscard]] ReadReport report() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace lanefuse
