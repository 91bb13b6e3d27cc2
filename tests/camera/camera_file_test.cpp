// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/camera_file.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "camera/camera_model.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

const std::string kText = R"(name: front
kind: serial_camera
image:
  width_px: 1280
  height_px: 720
lens:
  fx_px: 1160.5
  fy_px: 1155
  cx_px: 667
  cy_px: 388
  distortion: [-0.27, 0.1, 0.001, -0.002, 0]
mounting:
  x_m: -0.9
  y_m: 0.1
  height_m: 1.24
  roll_deg: 0.5
  pitch_deg: -1.6
  yaw_deg: -1.4
)";

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kText;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_refusal(const std::string& text, const std::string& place, const std::string& naming) {
  try {
    parse_camera(text, "camera.yaml");
    FAIL() << "taken:\n" << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::configuration);
    EXPECT_THAT(error.what(), HasSubstr(place));
    EXPECT_THAT(error.what(), HasSubstr(naming));
  }
}

TEST(CameraFile, ReadsEveryKey) {
  const SensorDescription camera = parse_camera(kText, "camera.yaml");
  EXPECT_EQ(camera.name, "front");
  EXPECT_EQ(camera.kind, SensorKind::serial_camera);
  ASSERT_TRUE(camera.camera);
  EXPECT_EQ(*camera.camera,
            (CameraIntrinsics{1280, 720, 1160.5, 1155, 667, 388, {-0.27, 0.1, 0.001, -0.002, 0}}));
  EXPECT_EQ(camera.mounting, (Mounting{-0.9, 0.1, 1.24, 0.5 * kDegree, -1.6 * kDegree, -1.4 * kDegree}));
}

TEST(CameraFile, WhatIsWrittenIsReadBack) {
  Random random(1, "cameras");
  for (const char* name :
       {"front", "12", "~", "a: b", "# no comment", "\"quoted\"", "Frontkamera \xC3\xBC"}) {
    SensorDescription camera = parse_camera(kText, "camera.yaml");
    camera.name = name;
    camera.kind = SensorKind::high_resolution_camera;
    camera.camera->fx = random.uniform(100, 4000);
    for (double& k : camera.camera->distortion) k = random.uniform(-1, 1);
    camera.mounting.x = random.uniform(-3, 3);
    camera.mounting.pitch = random.uniform(-0.1, 0.1);
    const SensorDescription back = parse_camera(to_yaml(camera), "written");
    EXPECT_NEAR(back.mounting.pitch, camera.mounting.pitch, 1e-10);
    SensorDescription rounded = camera;
    rounded.mounting = back.mounting;
    EXPECT_EQ(back, rounded);
    EXPECT_EQ(to_yaml(back), to_yaml(camera));
  }
}

TEST(CameraFile, KeepsRoundDegreesRound) {
  EXPECT_THAT(to_yaml(parse_camera(kText, "camera.yaml")), HasSubstr("pitch_deg: -1.6\n"));
}

TEST(CameraFile, NamesFileLineAndKeyOfWhatIsWrong) {
  expect_refusal(replaced("fy_px: 1155", "fy_px: 0"), "camera.yaml:8", "lens.fy_px");
  expect_refusal(replaced("fy_px: 1155", "fy_px: .nan"), "camera.yaml:8", "lens.fy_px");
  expect_refusal(replaced("fy_px: 1155", "fy_px: .inf"), "camera.yaml:8", "lens.fy_px");
  expect_refusal(replaced("fy_px: 1155", "fy_px: wide"), "camera.yaml:8", "'lens.fy_px' cannot be wide");
  expect_refusal(replaced("fy_px: 1155", "fv_px: 1155"), "camera.yaml:8", "unknown key 'lens.fv_px'");
  expect_refusal(replaced("  fy_px: 1155\n", ""), "camera.yaml", "'lens.fy_px' is missing");
  expect_refusal(replaced("fy_px: 1155", "fx_px: 1155"), "camera.yaml:8", "'lens.fx_px' is there twice");
  expect_refusal(replaced("width_px: 1280", "width_px: 12.5"), "camera.yaml:4", "image.width_px");
  expect_refusal(replaced("height_px: 720", "height_px: 60000"), "camera.yaml", "image of 1280 x 60000");
  expect_refusal(replaced("kind: serial_camera", "kind: odometry"), "camera.yaml:2",
                 "high_resolution_camera");
  expect_refusal(replaced("name: front", "name: ''"), "camera.yaml:1", "name");
  expect_refusal(replaced(", 0]", "]"), "camera.yaml:11", "lens.distortion");
  expect_refusal(replaced("-0.002, 0]", "-0.002, x]"), "camera.yaml:11", "lens.distortion");
  expect_refusal(replaced("height_m: 1.24", "height_m: -1"), "camera.yaml:15", "mounting.height_m");
  expect_refusal(replaced("yaw_deg: -1.4", "yaw_deg: 90"), "camera.yaml:18", "mounting.yaw_deg");
  expect_refusal(replaced("name: front", "name: front\nid: 3"), "camera.yaml:2", "unknown key 'id'");
  expect_refusal("", "camera.yaml", "no camera");
  expect_refusal("- 1\n- 2\n", "camera.yaml", "no camera");
  expect_refusal("image: [", "camera.yaml", "not YAML");
}

TEST(CameraFile, ACutFileIsRefusedOrHasLostOnlyDigits) {
  for (std::size_t length = 0; length + 1 < kText.size(); ++length) {
    try {
      parse_camera(kText.substr(0, length), "camera.yaml");
      EXPECT_GE(length, kText.find("yaw_deg: -1") + 11);
    } catch (const Error&) {
    }
  }
}

TEST(CameraFile, NamesAFileThatIsNotThere) { EXPECT_THROW(load_camera("/nowhere/camera.yaml"), Error); }

TEST(CameraFile, TheHighwayVideosCameraIsOne) {
  const SensorDescription camera =
      load_camera(std::string(LANEFUSE_SOURCE_DIR) + "/tests/data/highway_video_camera.yaml");
  EXPECT_EQ(camera.kind, SensorKind::camera);
  EXPECT_NO_THROW(CameraModel{*camera.camera});
  EXPECT_NEAR(camera.mounting.z, 1.24, 0.04);
}

}  // namespace
}  // namespace lanefuse
