// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/video.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "importing/motion_table.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

const std::filesystem::path kCameraFile =
    std::filesystem::path(LANEFUSE_SOURCE_DIR) / "tests/data/highway_video_camera.yaml";

std::filesystem::path written(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
  std::ofstream(file) << text;
  return file;
}

std::string problem_of(const VideoImport& import) {
  try {
    survey_video(import);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

VideoImport import_of(const std::filesystem::path& video) { return {.video = video, .camera = kCameraFile}; }

TEST(Video, NamesAFileThatIsNoVideo) {
  EXPECT_NE(problem_of(import_of("/nowhere/clip.mp4")).find("clip.mp4: cannot be read"), std::string::npos);
  const auto text = written("text.mp4", "no video at all");
  EXPECT_NE(problem_of(import_of(text)).find("text.mp4: is no video"), std::string::npos);
}

TEST(Video, RefusesFramesOfAnotherSize) {
  const auto clip = testing::real_data("highway_video/P4_cut_76f.mp4");
  LANEFUSE_NEEDS_DATA(clip);
  std::ifstream in(kCameraFile);
  std::string yaml((std::istreambuf_iterator<char>(in)), {});
  yaml.replace(yaml.find("height_px: 720"), 14, "height_px: 721");
  VideoImport import = import_of(clip);
  import.camera = written("other_size.yaml", yaml);
  EXPECT_NE(problem_of(import).find("1280 x 720 pixels, the camera's are 1280 x 721"), std::string::npos);
}

TEST(Video, RealClipHasItsFramesAndAMotorwaysSpeed) {
  const auto clip = testing::real_data("highway_video/P4_cut_76f.mp4");
  LANEFUSE_NEEDS_DATA(clip);
  VideoImport import = import_of(clip);
  import.dash_period = 14.63;
  const VideoMotion motion = survey_video(import);
  ASSERT_EQ(motion.motions.size(), 76U);
  EXPECT_GE(motion.frames_announced, 76);  // a container may promise more
  EXPECT_GT(motion.speed_min, 26);
  EXPECT_LT(motion.speed_max, 33);
  EXPECT_EQ(motion.scale_source, "dash period");
  EXPECT_NEAR(motion.scale, 1, 0.1);
  EXPECT_GT(motion.seen, 0.9);
  for (std::size_t i = 1; i < motion.motions.size(); ++i) {
    EXPECT_NEAR(*motion.motions[i].speed, *motion.motions[i - 1].speed, 0.5) << i;
  }
  std::size_t images = 0;
  write_video(import, motion, [&](const Measurement& measurement) {
    EXPECT_FALSE(implausible(measurement));
    if (std::holds_alternative<CameraImage>(measurement)) ++images;
  });
  EXPECT_EQ(images, motion.motions.size());
}

TEST(MotionTable, InterpolatesBetweenRows) {
  const MotionTable table(written("motion.csv", "time_s,speed_mps,yaw_rate_radps\n0,20,0.01\r\n1,22,0.03\n"));
  EXPECT_NEAR(table.at(0.5).speed, 21, 1e-12);
  EXPECT_NEAR(*table.at(0.5).yaw_rate, 0.02, 1e-12);
  EXPECT_NEAR(table.at(1.05).speed, 22, 1e-12);
  EXPECT_THROW(static_cast<void>(table.at(2)), Error);
  const MotionTable speeds(written("speeds.csv", "time_s,speed_mps\n0,20\n"));
  EXPECT_FALSE(speeds.at(0).yaw_rate);
}

TEST(MotionTable, NamesTheLineThatIsWrong) {
  const auto problem = [](const std::string& text) -> std::string {
    try {
      const MotionTable table(written("bad.csv", text));
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(problem("seconds,speed\n").find("bad.csv, line 1"), std::string::npos);
  EXPECT_NE(problem("time_s,speed_mps\n0,20\n1,x\n").find("bad.csv, line 3"), std::string::npos);
  EXPECT_NE(problem("time_s,speed_mps\n0,20\n0,21\n").find("time does not rise"), std::string::npos);
  EXPECT_NE(problem("time_s,speed_mps\n").find("no rows"), std::string::npos);
}

}  // namespace
}  // namespace lanefuse
