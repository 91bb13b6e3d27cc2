// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/video_writer.hpp"

#include <cassert>
#include <fstream>
#include <opencv2/videoio.hpp>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

struct Codec {
  const char* name;
  int fourcc;
};

// The encoder of the first is GPL software that not every system has; the second is always there.
const Codec kCodecs[] = {{"H.264", cv::VideoWriter::fourcc('a', 'v', 'c', '1')},
                         {"MPEG-4", cv::VideoWriter::fourcc('m', 'p', '4', 'v')}};

std::filesystem::path part_of(const std::filesystem::path& path) {
  // The container is chosen by the ending.
  return path.parent_path() / fmt::format(".{}.part.mp4", path.stem().string());
}

}  // namespace

class VideoWriter::Session {
 public:
  Session(const std::filesystem::path& path, cv::Size size, double frames_per_second)
      : path_(path), part_(part_of(path)), size_(size) {
    if (!std::ofstream(part_)) throw input_error(path.string(), "could not be written");
    for (const Codec& codec : kCodecs) {
      if (open(codec, frames_per_second)) return;
    }
    std::filesystem::remove(part_);
    throw configuration_error(path.string(), "no codec for video is there",
                              "install OpenCV's videoio with FFmpeg, and libx264 or libavcodec's MPEG-4");
  }
  ~Session() {
    writer_.release();
    if (closed_) return;
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void write(const ImageView& image) {
    assert(image.width == size_.width && image.height == size_.height && image.channels == 3);
    writer_.write(cv::Mat(image.height, image.width, CV_8UC3,
                          const_cast<std::uint8_t*>(image.data),  // NOLINT: it is only read
                          static_cast<std::size_t>(image.stride)));
    ++frames_;
  }

  void close() {
    writer_.release();
    std::error_code failed;
    const auto bytes = std::filesystem::file_size(part_, failed);
    if (!failed && bytes > 0) std::filesystem::rename(part_, path_, failed);
    if (failed || bytes == 0) {
      throw input_error(path_.string(), "could not be written", "is there room on the disk?");
    }
    closed_ = true;
  }

  [[nodiscard]] std::int64_t frames() const { return frames_; }
  [[nodiscard]] const std::string& codec() const { return codec_; }

 private:
  bool open(const Codec& codec, double frames_per_second) {
    try {
      if (!writer_.open(part_.string(), cv::CAP_FFMPEG, codec.fourcc, frames_per_second, size_)) return false;
    } catch (const cv::Exception&) {
      return false;
    }
    codec_ = codec.name;
    return true;
  }

  std::filesystem::path path_;
  std::filesystem::path part_;
  cv::Size size_;
  cv::VideoWriter writer_;
  std::string codec_;
  std::int64_t frames_ = 0;
  bool closed_ = false;
};

VideoWriter::VideoWriter(const std::filesystem::path& path, int width, int height, double frames_per_second) {
  assert(width > 0 && height > 0 && width % 2 == 0 && height % 2 == 0 && frames_per_second > 0);
  session_ = std::make_unique<Session>(path, cv::Size(width, height), frames_per_second);
}
VideoWriter::~VideoWriter() = default;
void VideoWriter::write(const ImageView& image) { session_->write(image); }
void VideoWriter::close() { session_->close(); }
std::int64_t VideoWriter::frames() const { return session_->frames(); }
const std::string& VideoWriter::codec() const { return session_->codec(); }

}  // namespace lanefuse
