// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_plane_motion.hpp"

#include <gtest/gtest.h>

#include "support/painted_road.hpp"

namespace lanefuse {
namespace {

using testing::PaintedRoad;

constexpr double kSeconds = 0.04;
const CameraIntrinsics kCamera{640, 360, 580, 580, 319.5, 179.5, {-0.1, 0, 0, 0, 0}};

/// What is painted over the road in every image.
enum class FixedToTheCar { nothing, reflection };

struct Drive {
  double speed = 0;
  double yaw_rate = 0;
  double pitch_step = 0;  ///< [rad] the nose goes down with every other image, and up again
  FixedToTheCar fixed = FixedToTheCar::nothing;
};

void paint_reflection(Image& image) {
  for (int v = 262; v < 268; ++v) {
    for (int u = 0; u < 640; ++u)
      std::fill_n(image.row(v) + 3 * u, 3, static_cast<std::uint8_t>(120 + 9 * (u / 7 % 9)));
  }
}

CameraPose pose_of_camera() {
  CameraPose pose;
  pose.mounting.z = 1.3;
  pose.mounting.pitch = 0.02;
  return pose;
}

/// The estimate after so many images of a steady drive.
RoadPlaneMotionEstimate after(const Drive& drive, int images) {
  const PaintedRoad road{CameraModel(kCamera)};
  RoadPlaneMotion motion(kCamera);
  PaintedRoad::View view;
  RoadPlaneMotionEstimate last;
  for (int i = 0; i < images; ++i) {
    view.pose = pose_of_camera();
    view.pose.mounting.pitch += i % 2 == 0 ? 0 : drive.pitch_step;
    Image image = road.paint(view);
    if (drive.fixed == FixedToTheCar::reflection) paint_reflection(image);
    last = motion.update({image.view(), pose_of_camera(), kSeconds, {}});
    const double yaw = view.yaw + drive.yaw_rate * kSeconds / 2;
    view.x += drive.speed * kSeconds * std::cos(yaw);
    view.y += drive.speed * kSeconds * std::sin(yaw);
    view.yaw += drive.yaw_rate * kSeconds;
  }
  return last;
}

TEST(RoadPlaneMotion, FindsAnySpeedWithoutBeingTold) {
  for (const double speed : {4.0, 17.0, 31.0, 45.0}) {
    const RoadPlaneMotionEstimate found = after({.speed = speed}, 6);
    EXPECT_TRUE(found.measured) << speed;
    EXPECT_NEAR(found.speed, speed, 0.03 * speed + 0.2);
    EXPECT_NEAR(found.yaw_rate, 0, 0.01);
    EXPECT_GT(found.quality, 0.4);
  }
}

TEST(RoadPlaneMotion, SeesACurve) {
  const RoadPlaneMotionEstimate found = after({.speed = 25, .yaw_rate = 0.05}, 8);
  EXPECT_NEAR(found.speed, 25, 0.6);
  EXPECT_NEAR(found.yaw_rate, 0.05, 0.01);
}

TEST(RoadPlaneMotion, TellsNoddingFromDriving) {
  // Of an even number of images the last one has its nose down, against the one before.
  const RoadPlaneMotionEstimate found = after({.speed = 25, .pitch_step = 0.003}, 8);
  EXPECT_NEAR(found.pitch_change, 0.003, 0.0006);
  EXPECT_NEAR(found.speed, 25, 0.8);
}

TEST(RoadPlaneMotion, StandsWhereTheRoadStands) {
  const RoadPlaneMotionEstimate found = after({.speed = 0}, 5);
  EXPECT_TRUE(found.measured);
  EXPECT_NEAR(found.speed, 0, 0.1);
}

TEST(RoadPlaneMotion, AReflectionDoesNotHoldItStill) {
  const RoadPlaneMotionEstimate found = after({.speed = 30, .fixed = FixedToTheCar::reflection}, 6);
  EXPECT_NEAR(found.speed, 30, 1.5);
}

TEST(RoadPlaneMotion, BlankImagesMeasureNothing) {
  RoadPlaneMotion motion(kCamera);
  const Image blank(640, 360, 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(motion.update({blank.view(), pose_of_camera(), kSeconds, {}}).measured);
  }
}

TEST(RoadPlaneMotion, SameImagesGiveSameNumbers) {
  const RoadPlaneMotionEstimate first = after({.speed = 20}, 4);
  const RoadPlaneMotionEstimate second = after({.speed = 20}, 4);
  EXPECT_EQ(first.speed, second.speed);
  EXPECT_EQ(first.pitch_change, second.pitch_change);
}

}  // namespace
}  // namespace lanefuse
