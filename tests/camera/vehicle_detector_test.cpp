// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/vehicle_detector.hpp"

#include <gtest/gtest.h>

#include "support/painted_road.hpp"

namespace lanefuse {
namespace {

using testing::PaintedRoad;

constexpr double kSeconds = 0.04;
constexpr double kSpeed = 25;
const CameraIntrinsics kCamera{640, 360, 580, 580, 319.5, 179.5, {}};

CameraPose pose_of_camera() {
  CameraPose pose;
  pose.mounting.z = 1.3;
  return pose;
}

void fill(Image& image, const Eigen::Vector4i& box, int grey) {
  for (int v = std::max(0, box[1]); v < std::min(image.height(), box[3]); ++v) {
    for (int u = std::max(0, box[0]); u < std::min(image.width(), box[2]); ++u) {
      std::fill_n(image.row(v) + 3 * u, 3, static_cast<std::uint8_t>(grey));
    }
  }
}

/// The rear of a car at x, y: bright body, dark window, lamps, a lettered plate, the bumper's trim and the
/// shadow under it.
Eigen::Vector4i paint_car(Image& image, double x, double y) {
  const CameraModel camera(kCamera);
  const GroundProjection projection(camera, pose_of_camera());
  const Eigen::Vector2d low = *projection.pixel({x, y + 0.9});
  const Eigen::Vector2d high = *projection.pixel({x, y - 0.9}, 1.45);
  const Eigen::Vector4i box(static_cast<int>(low.x()), static_cast<int>(high.y()), static_cast<int>(high.x()),
                            static_cast<int>(low.y()));
  const int width = box[2] - box[0];
  const int height = box[3] - box[1];
  fill(image, box, 210);
  fill(image, {box[0] + width / 8, box[1] + height / 10, box[2] - width / 8, box[1] + height * 4 / 10}, 40);
  fill(image, {box[0], box[1] + height / 2, box[0] + width / 5, box[1] + height * 6 / 10}, 90);
  fill(image, {box[2] - width / 5, box[1] + height / 2, box[2], box[1] + height * 6 / 10}, 90);
  fill(image,
       {box[0] + width * 2 / 5, box[1] + height * 6 / 10, box[2] - width * 2 / 5, box[1] + height * 7 / 10},
       130);
  for (int letter = 0; letter < 3; ++letter) {
    const int left = box[0] + width * (84 + 12 * letter) / 200;
    fill(image, {left, box[1] + height * 62 / 100, left + width / 33, box[1] + height * 68 / 100}, 30);
  }
  fill(image, {box[0], box[1] + height * 76 / 100, box[2], box[1] + height * 80 / 100}, 60);
  fill(image, {box[0], box[3] - std::max(2, height / 8), box[2], box[3]}, 15);
  return box;
}

/// Drives for some images behind a car (or none) that keeps its distance.
class Follower {
 public:
  const std::vector<VehicleBox>& drive(int images, std::optional<Eigen::Vector2d> car) {
    const std::vector<VehicleBox>* boxes = nullptr;
    for (int i = 0; i < images; ++i) {
      Image image = road_.paint({.x = way_, .y = 0, .yaw = 0, .pose = pose_of_camera()});
      if (car) painted_ = paint_car(image, car->x(), car->y());
      boxes = &detector_.detect({image.view(), pose_of_camera(), kSpeed, 0, kSeconds});
      way_ += kSpeed * kSeconds;
    }
    return *boxes;
  }
  [[nodiscard]] const Eigen::Vector4i& painted() const { return painted_; }

 private:
  PaintedRoad road_{CameraModel(kCamera), 0.3};
  VehicleDetector detector_{kCamera};
  double way_ = 0;
  Eigen::Vector4i painted_ = Eigen::Vector4i::Zero();
};

TEST(VehicleDetector, SeesNothingOnAnEmptyRoad) {
  Follower follower;
  EXPECT_TRUE(follower.drive(10, std::nullopt).empty());
}

TEST(VehicleDetector, BoxesACarAndTellsWhereItIs) {
  for (const double distance : {16.0, 20.0, 24.0, 30.0}) {
    Follower follower;
    const std::vector<VehicleBox>& boxes = follower.drive(5, Eigen::Vector2d(distance, 0.3));
    ASSERT_EQ(boxes.size(), 1U) << distance;
    const VehicleBox& box = boxes[0];
    const double width = follower.painted()[2] - follower.painted()[0];
    EXPECT_NEAR(box.left, follower.painted()[0], 0.25 * width) << distance;
    EXPECT_NEAR(box.right, follower.painted()[2], 0.25 * width) << distance;
    EXPECT_NEAR(box.bottom, follower.painted()[3], 0.15 * width) << distance;
    EXPECT_NEAR(box.distance, distance, 0.15 * distance);
    EXPECT_NEAR(box.lateral, 0.3, 0.5);
    EXPECT_GT(box.confidence, 0.5);
  }
}

TEST(VehicleDetector, NeedsSeveralImages) {
  Follower follower;
  EXPECT_TRUE(follower.drive(2, Eigen::Vector2d(20, 0)).empty());
}

TEST(VehicleDetector, KeepsABoxForAWhileAndNotForLong) {
  Follower follower;
  ASSERT_EQ(follower.drive(8, Eigen::Vector2d(20, 0)).size(), 1U);
  EXPECT_EQ(follower.drive(3, std::nullopt).size(), 1U);
  EXPECT_TRUE(follower.drive(15, std::nullopt).empty());
}

}  // namespace
}  // namespace lanefuse
