// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/video_writer.hpp"

#include <opencv2/videoio.hpp>

#include <gtest/gtest.h>

#include "camera/image_codec.hpp"
#include "core/error.hpp"
#include "drawing/canvas.hpp"
#include "drawing/picture_file.hpp"
#include "support/files.hpp"

namespace lanefuse {
namespace {

Canvas painted(double place) {
  Canvas canvas(160, 96, {40, 40, 40});
  canvas.fill(Box{place, 20, 40, 40}, {230, 230, 230});
  return canvas;
}

TEST(VideoWriter, HoldsEveryImageInOrder) {
  const testing::TemporaryFolder folder;
  VideoWriter video(folder / "a.mp4", 160, 96, 25);
  for (int i = 0; i < 30; ++i) video.write(painted(4.0 * i).image().view());
  EXPECT_EQ(video.frames(), 30);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mp4")) << "not before it is whole";
  video.close();
  cv::VideoCapture capture((folder / "a.mp4").string());
  ASSERT_TRUE(capture.isOpened());
  EXPECT_NEAR(capture.get(cv::CAP_PROP_FPS), 25, 0.01);
  int count = 0;
  for (cv::Mat frame; capture.read(frame); ++count) {
    ASSERT_EQ(frame.size(), cv::Size(160, 96));
    EXPECT_GT(frame.at<cv::Vec3b>(40, std::min(4 * count + 20, 159))[1], 180) << count;
  }
  EXPECT_EQ(count, 30);
}

TEST(VideoWriter, LeavesNothingBehindWhereItIsBrokenOff) {
  const testing::TemporaryFolder folder;
  {
    VideoWriter video(folder / "a.mp4", 160, 96, 25);
    video.write(painted(0).image().view());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(VideoWriter, NamesAFileThatCannotBeWritten) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(VideoWriter(folder / "no such folder/a.mp4", 160, 96, 25), Error);
}

TEST(PictureFile, IsReadBackAsItWas) {
  const testing::TemporaryFolder folder;
  const Canvas canvas = painted(30);
  write_picture(folder / "a.png", canvas.image().view());
  const std::optional<Image> back = decode_image(testing::read_file(folder / "a.png"));
  ASSERT_TRUE(back);
  EXPECT_EQ(std::memcmp(back->view().data, canvas.image().view().data, 160 * 96 * 3), 0);
  write_picture(folder / "a.jpg", canvas.image().view());
  EXPECT_TRUE(decode_image(testing::read_file(folder / "a.jpg")));
  EXPECT_THROW(write_picture(folder / "a.txt", canvas.image().view()), Error);
  EXPECT_THROW(write_picture(folder / "none/a.png", canvas.image().view()), Error);
}

}  // namespace
}  // namespace lanefuse
