// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/video_frames.hpp"

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {

class VideoFrames::Capture {
 public:
  cv::VideoCapture video;
  cv::Mat frame;
};

VideoFrames::VideoFrames(const std::filesystem::path& file) : capture_(std::make_unique<Capture>()) {
  if (!std::filesystem::is_regular_file(file)) {
    throw input_error(file.string(), "cannot be read", "give the path of a video file");
  }
  if (!capture_->video.open(file.string(), cv::CAP_FFMPEG)) {
    throw input_error(file.string(), "is no video that can be decoded");
  }
  constexpr double kSlowest = 1;
  constexpr double kFastest = 1000;
  const double rate = frames_per_second();
  if (!(rate >= kSlowest && rate <= kFastest)) {
    throw input_error(file.string(), fmt::format("{} frames a second cannot be", rate),
                      "copy it into a container with a frame rate");
  }
}

VideoFrames::~VideoFrames() = default;

double VideoFrames::frames_per_second() const { return capture_->video.get(cv::CAP_PROP_FPS); }

std::int64_t VideoFrames::announced() const {
  return static_cast<std::int64_t>(capture_->video.get(cv::CAP_PROP_FRAME_COUNT));
}

bool VideoFrames::next() { return capture_->video.read(capture_->frame) && !capture_->frame.empty(); }

ImageView VideoFrames::image() const {
  const cv::Mat& frame = capture_->frame;
  return {frame.data, frame.cols, frame.rows, frame.channels(), static_cast<std::ptrdiff_t>(frame.step[0])};
}

}  // namespace lanefuse
