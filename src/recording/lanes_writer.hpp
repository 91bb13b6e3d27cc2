// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "core/lane_estimate.hpp"
#include "recording/run_info.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// Records estimated lanes with their inside view, and once more as a drawing and as OSI for other tools.
/// What DriveWriter says of the file holds here too.
class LanesWriter {
 public:
  LanesWriter(const std::filesystem::path& path, const DriveInfo& drive, const RunInfo& run);
  ~LanesWriter();
  LanesWriter(LanesWriter&&) noexcept;
  LanesWriter& operator=(LanesWriter&&) noexcept;

  /// One cycle, with what the cameras saw since the one before and the vehicles tracked; in order of time.
  /// Throws Error (input) where the time lies before 1970 or the disk fails.
  void write(const LaneEstimate& estimate, const DebugView& debug, std::span<const CameraView> cameras = {},
             std::span<const TrackedObject> objects = {});

  void close();

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace lanefuse
