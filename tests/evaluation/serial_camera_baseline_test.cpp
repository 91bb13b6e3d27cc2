// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/serial_camera_baseline.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "evaluation/exact_truth.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

using testing::RoadScene;

constexpr double kPaint = 0.2;  // [m] wide

/// What a camera without errors hands over of that scene: the inner edges of the ego lane's paint.
SerialLane seen(const RoadScene& scene, Time measured_at, double range = 60) {
  SerialLane lane;
  lane.stamp = {measured_at, measured_at + std::chrono::milliseconds(60), 2};
  lane.marking_width = kPaint;
  for (const int boundary : {1, 2}) {
    ClothoidMeasurement measurement;
    measurement.clothoid = scene.boundary(boundary);
    measurement.clothoid.lateral_offset += boundary == 1 ? -kPaint / 2 : kPaint / 2;
    measurement.covariance = Eigen::Vector4d(1e-3, 1e-5, 1e-8, 1e-12).asDiagonal();
    measurement.range_end = range;
    (boundary == 1 ? lane.left : lane.right) = measurement;
  }
  return lane;
}

VehicleMotion driving(double speed, double yaw_rate) {
  VehicleMotion motion;
  motion.speed = speed;
  motion.yaw_rate = yaw_rate;
  return motion;
}

const Time kStart = from_nanoseconds(1'000'000'000);

TEST(SerialCameraBaseline, FollowsTheCentreOfThePaint) {
  const RoadScene scene;
  SerialCameraBaseline camera;
  camera.add(seen(scene, kStart));
  const LaneEstimate estimate = camera.at(kStart);
  ASSERT_EQ(estimate.boundaries.size(), 2U);
  EXPECT_NEAR(estimate.boundaries[0].clothoid.y(0), scene.boundary(1).y(0), 1e-9);
  EXPECT_NEAR(estimate.boundaries[1].clothoid.y(40), scene.boundary(2).y(40), 1e-6);
  EXPECT_EQ(estimate.boundaries[0].range_end, 60);
  ASSERT_NE(ego_lane(estimate), nullptr);
}

TEST(SerialCameraBaseline, IsMovedToTheTimeAskedFor) {
  const RoadScene scene;
  SerialCameraBaseline camera;
  camera.add(driving(30, 0.01));
  camera.add(seen(scene, kStart));
  const Pose2 moved = constant_turn(30, 0.01, 0.1);
  const LaneEstimate estimate = camera.at(kStart + std::chrono::milliseconds(100));
  const Eigen::Vector2d there = moved * Eigen::Vector2d(20, estimate.boundaries[0].clothoid.y(20));
  EXPECT_NEAR(there.y(), scene.boundary(1).y(there.x()), 1e-3);
  EXPECT_NEAR(estimate.boundaries[0].range_end, 57, 0.01);
}

TEST(SerialCameraBaseline, ForgetsWhatIsTooOldAndWhatIsImplausible) {
  const RoadScene scene;
  SerialCameraBaseline camera;
  SerialLane broken = seen(scene, kStart);
  broken.left->clothoid.heading = std::nan("");
  camera.add(broken);
  EXPECT_EQ(camera.at(kStart).boundaries.size(), 1U);  // the right one
  camera.add(seen(scene, kStart));
  EXPECT_EQ(camera.at(kStart + std::chrono::milliseconds(300)).boundaries.size(), 2U);
  EXPECT_TRUE(camera.at(kStart + std::chrono::milliseconds(301)).boundaries.empty());
}

TEST(SerialCameraBaseline, OneMarkingAloneIsNoLane) {
  const RoadScene scene;
  SerialLane half = seen(scene, kStart);
  half.right.reset();
  SerialCameraBaseline camera;
  camera.add(half);
  EXPECT_EQ(camera.at(kStart).boundaries.size(), 1U);
  EXPECT_EQ(ego_lane(camera.at(kStart)), nullptr);
}

TEST(SerialCameraBaseline, IsJudgedBesideTheEstimateAndChangesNothingOfIt) {
  RoadScene scene;
  scene.course.curvature_rate = 0;
  const TrueRoad road = testing::true_road(scene);
  TrueFrame frame = testing::true_frame(scene);
  frame.time = kStart;
  LaneEstimate estimate = testing::perfect_estimate(scene);
  estimate.time = kStart;
  SerialCameraBaseline camera;
  camera.add(seen(scene, kStart));
  const LaneEstimate alone = camera.at(kStart);
  ExactTruthEvaluation with(road), without(road);
  with.add(estimate, frame, &alone);
  without.add(estimate, frame);
  const EvaluationResult result = with.result();
  EXPECT_FALSE(without.result().serial_camera);
  ASSERT_TRUE(result.serial_camera);
  EXPECT_EQ(result.serial_camera->within_range[6].n, 2U);
  EXPECT_EQ(result.serial_camera->within_range[7].availability, 0);
  EXPECT_EQ(result.serial_camera->extrapolated[12].n, 2U);
  EXPECT_NEAR(result.serial_camera->extrapolated[12].rmse_m, 0, 1e-2);
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    EXPECT_EQ(result.lanes.ego[i].rmse_m, without.result().lanes.ego[i].rmse_m);
  }
}

}  // namespace
}  // namespace lanefuse
