// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "camera/image.hpp"

namespace lanefuse {

/// The frames of a video file, one after the other: whatever OpenCV's video backends decode.
class VideoFrames {
 public:
  /// Throws an input Error where the file cannot be opened, or names no frame rate that can be believed.
  explicit VideoFrames(const std::filesystem::path& file);
  ~VideoFrames();

  [[nodiscard]] double frames_per_second() const;
  /// How many frames the container says that it holds; some say more than can be decoded.
  [[nodiscard]] std::int64_t announced() const;

  /// Decodes the next frame; false after the last one.
  bool next();
  /// The frame of the last next() that was true; the same pixels until the next call.
  [[nodiscard]] ImageView image() const;

 private:
  class Capture;
  std::unique_ptr<Capture> capture_;
};

}  // namespace lanefuse
