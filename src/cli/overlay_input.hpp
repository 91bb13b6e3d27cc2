// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "recording/drive_reader.hpp"
#include "recording/lanes_reader.hpp"

namespace lanefuse {

/// One image of a drive with what the run made of it.
struct OverlayFrame {
  double seconds = 0;  ///< since the first cycle
  CameraImage image;
  std::optional<CameraView> view;            ///< nothing where the run did not look at this image
  std::shared_ptr<const LaneRecord> record;  ///< the cycle that took it in, else one near in time, else null
};

/// Goes through a drive's images of one camera and finds the views and lanes that belong to each. Reads both
/// recordings once, side by side: memory does not grow with the drive.
class OverlayInput {
 public:
  /// The first camera that hands over images where none is named. Throws an Error (configuration) where there
  /// is none of that name, and (input) where the drive has no images or the lanes no cycle.
  OverlayInput(const std::filesystem::path& lanes, const std::filesystem::path& drive,
               const std::optional<std::string>& camera);

  [[nodiscard]] const SensorDescription& camera() const { return camera_; }
  [[nodiscard]] double frames_per_second() const { return frames_per_second_; }

  /// The next image; false at the end.
  bool next(OverlayFrame& frame);

 private:
  DriveReader drive_;
  LanesReader lanes_;
  SensorDescription camera_;
  double frames_per_second_;
  Time first_cycle_{};
  std::deque<std::shared_ptr<const LaneRecord>> window_;  ///< cycles around the image

  bool read_cycle();
  [[nodiscard]] bool find_view(OverlayFrame& frame) const;
  void find_nearest(OverlayFrame& frame) const;
};

}  // namespace lanefuse
