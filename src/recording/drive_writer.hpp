// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "core/time.hpp"
#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"
#include "sensors/rig.hpp"
#include "sensors/truth.hpp"

namespace lanefuse {

/// Records a drive: an indexed MCAP file as docs/recording-format.md describes it.
///
/// The file appears at `path` with close(), in place of what was there; without close() nothing is left. The
/// same calls give the same bytes. Memory does not grow with the drive.
class DriveWriter {
 public:
  /// Throws Error (input) where the file cannot be written.
  DriveWriter(const std::filesystem::path& path, const DriveInfo& info, const Rig& rig);
  ~DriveWriter();
  DriveWriter(DriveWriter&&) noexcept;
  DriveWriter& operator=(DriveWriter&&) noexcept;

  /// Best in order of `received_at`: readers sort, but only so far as memory allows. A motion with wheel
  /// speeds beside speed or yaw rate is recorded, and read back, as two measurements. Throws Error (input)
  /// where the sensor is not in the rig, a time lies before 1970, an object's id is below zero, or the disk
  /// fails.
  void write(const Measurement& measurement);

  /// The truth, beside the drive; whoever reads measurements never opens it.
  void write(const TrueRoad& road, Time time);
  void write(const TrueFrame& frame);

  /// Once, at the end.
  void close();

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace lanefuse
