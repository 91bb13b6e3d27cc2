// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "camera/image.hpp"

namespace lanefuse {

/// Writes a video (.mp4): H.264 where this machine can encode it, else MPEG-4. The file appears at `path`
/// with close(), in place of what was there; without close() nothing is left.
class VideoWriter {
 public:
  /// `width` and `height` are even. Throws a configuration Error where no codec is there, and an input Error
  /// where the file cannot be written.
  VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// `image` has the video's size and three channels: blue, green, red.
  void write(const ImageView& image);
  /// Once, at the end.
  void close();

  [[nodiscard]] std::int64_t frames() const;
  [[nodiscard]] const std::string& codec() const;  ///< "H.264" or "MPEG-4"

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace lanefuse
