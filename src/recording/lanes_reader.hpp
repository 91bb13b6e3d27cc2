// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/lane_estimate.hpp"
#include "recording/read_report.hpp"
#include "recording/run_info.hpp"
#include "sensors/camera_view.hpp"
#include "sensors/drive.hpp"
#include "sensors/measurement.hpp"

namespace lanefuse {

/// One recorded cycle.
struct LaneRecord {
  LaneEstimate estimate;
  DebugView debug;                     ///< empty where the recording has lost it
  std::vector<CameraView> cameras;     ///< what the cameras saw since the cycle before
  std::vector<TrackedObject> objects;  ///< tracked vehicles, in the vehicle frame of this cycle
};

/// Replays recorded lanes, in order of time.
class LanesReader {
 public:
  /// Throws Error (input) naming what is wrong: no recorded lanes, an unknown version, another frame, no
  /// /out/lanes.
  explicit LanesReader(const std::filesystem::path& path);
  ~LanesReader();
  LanesReader(LanesReader&&) noexcept;
  LanesReader& operator=(LanesReader&&) noexcept;

  [[nodiscard]] const DriveInfo& drive() const;  ///< that the lanes were estimated from
  [[nodiscard]] const RunInfo& run() const;

  /// The next cycle; false at the end. Messages that cannot be understood are left out and counted in
  /// report().
  bool next(LaneRecord& record);

  /// As next(), but leaves the fused features undecoded: they are most of a recording, and only pictures need
  /// them. complete() decodes those of the cycle that came last.
  bool next_without_features(LaneRecord& record);
  /// Throws Error (input) where they cannot be understood.
  void complete(LaneRecord& record) const;

  [[nodiscard]] ReadReport report() const;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace lanefuse
