// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_boxes_model.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "camera/ground_projection.hpp"
#include "simulation/detection_scene.hpp"
#include "simulation/line_of_sight.hpp"
#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::car;
using testing::exact_detections;
using testing::look;
using testing::Moments;
using testing::open_country;

constexpr double kDegree = std::numbers::pi / 180;

std::vector<BoxDetection> boxes_of(CameraBoxesModel& sensor, const Scene& scene) {
  return look<CameraBoxes>(sensor, scene).boxes;
}

TEST(CameraBoxesModel, DescribesACameraThatSeesTheHorizon) {
  const SensorDescription camera = CameraBoxesModel(nominal_preset(), 1).description();
  EXPECT_EQ(camera.kind, SensorKind::object_camera);
  ASSERT_TRUE(camera.camera);
  EXPECT_EQ(camera.camera->width, 1176);
  EXPECT_EQ(camera.camera->height, 640);
  EXPECT_NEAR(camera.camera->fx, 1 / 0.79e-3, 1e-9);
  EXPECT_EQ(camera.mounting.z, 1.25);
  const CameraModel model(*camera.camera);
  const double horizon = GroundProjection(model, {camera.mounting}).horizon_row(500);
  EXPECT_GT(horizon, 100);
  EXPECT_LT(horizon, 540);
}

TEST(CameraBoxesModel, BoxesProjectBackToTheVehicle) {
  CameraBoxesModel sensor(exact_detections(), 1);
  const CameraModel camera(*sensor.description().camera);
  const Scene scene =
      open_country(car(0, {10, 20, 0.4}, 30), {car(1, Pose2{10, 20, 0.4} * Pose2{40, 0, 0}, 25)});
  const CameraBoxes seen = look<CameraBoxes>(sensor, scene);
  EXPECT_EQ(seen.stamp.received_at - seen.stamp.measured_at, std::chrono::milliseconds(60));
  ASSERT_EQ(seen.boxes.size(), 1u);
  const BoxDetection& box = seen.boxes[0];
  const GroundProjection projection(camera, {sensor.description().mounting});
  const auto left = projection.ground({box.left, box.bottom});
  const auto right = projection.ground({box.right, box.bottom});
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->x(), 40, 1e-6);
  EXPECT_NEAR(left->y(), 0.9, 1e-6);
  EXPECT_NEAR(right->y(), -0.9, 1e-6);
  const double height = body_of(scene.vehicles[0]).height;
  EXPECT_NEAR(box.bottom - box.top, height / 40 / 0.79e-3, 1e-6);
  EXPECT_EQ(sensor.true_mounting_of_last(), sensor.description().mounting);
}

TEST(CameraBoxesModel, ImagesWithTheTruePoseOfEachImage) {
  SensorPreset preset = exact_detections();
  preset.camera_pose = nominal_preset().camera_pose;
  Moments pitch, yaw;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    CameraBoxesModel sensor(preset, seed);
    const CameraModel camera(*sensor.description().camera);
    const Scene scene = open_country(car(0, {}, 30), {car(1, {40, 1, 0}, 25)});
    for (int i = 0; i < 25; ++i) {
      const BoxDetection box = boxes_of(sensor, scene).at(0);
      const Mounting& truth = sensor.true_mounting_of_last();
      const auto left = GroundProjection(camera, {truth}).ground({box.left, box.bottom});
      ASSERT_TRUE(left);
      EXPECT_NEAR(left->x(), 40, 0.05);  // by the turned camera the lowest corner is not always the left one
      EXPECT_NEAR(left->y(), 1.9, 0.01);
      pitch.add(truth.pitch / kDegree);
      yaw.add(truth.yaw / kDegree);
    }
  }
  EXPECT_NEAR(pitch.rms(), 0.12, 0.015);
  EXPECT_NEAR(yaw.rms(), 0.12, 0.03);
}

TEST(CameraBoxesModel, ErrsAsThePresetSays) {
  SensorPreset preset = exact_detections();
  CameraBoxesModel exact(preset, 1);
  preset.camera_boxes.sigma_edge_px = 1.5;
  preset.camera_boxes.sigma_base_px = 2.5;
  CameraBoxesModel noisy(preset, 1);
  const Scene scene = open_country(car(0, {}, 30), {car(1, {40, 1, 0}, 25)});
  Moments left, right, top, bottom;
  for (int i = 0; i < 3000; ++i) {
    const BoxDetection truth = boxes_of(exact, scene).at(0);
    const BoxDetection seen = boxes_of(noisy, scene).at(0);
    left.add(seen.left - truth.left);
    right.add(seen.right - truth.right);
    top.add(seen.top - truth.top);
    bottom.add(seen.bottom - truth.bottom);
    ASSERT_TRUE(is_plausible(seen));
  }
  for (const Moments& edge : {left, right, top}) EXPECT_NEAR(edge.rms(), 1.5, 0.1);
  EXPECT_NEAR(bottom.rms(), 2.5, 0.15);
}

TEST(CameraBoxesModel, MissesMoreFartherAway) {
  SensorPreset preset = exact_detections();
  preset.camera_boxes.detection_near = 0.97;
  preset.camera_boxes.detection_at_90_m = 0.5;
  const auto share_at = [&](double distance) {
    CameraBoxesModel sensor(preset, 1);
    const Scene scene = open_country(car(0, {}, 30), {car(1, {distance, 0, 0}, 25)});
    Moments seen;
    for (int i = 0; i < 2000; ++i) seen.add(static_cast<double>(boxes_of(sensor, scene).size()));
    return seen.mean();
  };
  EXPECT_NEAR(share_at(15), 0.97 - 0.47 * 15 / 90, 0.03);
  EXPECT_NEAR(share_at(89), 0.97 - 0.47 * 89 / 90, 0.04);
  EXPECT_EQ(share_at(91), 0);
}

TEST(CameraBoxesModel, SeesNeitherTheHiddenNorBeyondItsVisibilityNorBehind) {
  CameraBoxesModel sensor(exact_detections(), 1);
  const auto boxes = [&](const std::vector<SceneVehicle>& vehicles, double visibility) {
    Scene scene = open_country(car(0, {}, 30), vehicles);
    scene.visibility = visibility;
    return boxes_of(sensor, scene).size();
  };
  const SceneVehicle near = car(1, {20, 0, 0}, 30);
  EXPECT_EQ(boxes({near}, INFINITY), 1u);
  EXPECT_EQ(boxes({near, car(2, {50, 0.5, 0}, 30)}, INFINITY), 1u);
  EXPECT_EQ(boxes({near, car(2, {50, 2.8, 0}, 30)}, INFINITY), 2u);
  EXPECT_EQ(boxes({near, car(2, {50, 4, 0}, 30)}, 30), 1u);
  EXPECT_EQ(boxes({near}, 0), 0u);
  EXPECT_EQ(boxes({car(1, {-20, 0, 0}, 30)}, INFINITY), 0u);
  EXPECT_EQ(boxes({car(1, {10, 12, 0}, 30)}, INFINITY), 0u);
}

TEST(CameraBoxesModel, InventsABoxNowAndThen) {
  SensorPreset preset = exact_detections();
  preset.camera_boxes.false_boxes = 0.2;
  CameraBoxesModel sensor(preset, 1);
  const CameraIntrinsics camera = *sensor.description().camera;
  const Scene empty = open_country(car(0, {}, 30), {});
  Moments count;
  for (int i = 0; i < 3000; ++i) {
    double boxes = 0;
    for (const BoxDetection& box : boxes_of(sensor, empty)) {
      boxes += 1;
      ASSERT_TRUE(is_plausible(box));
      EXPECT_GE(box.left, -0.5);
      EXPECT_LE(box.right, camera.width - 0.5);
      EXPECT_GT(box.bottom, camera.cy);
    }
    count.add(boxes);
  }
  EXPECT_NEAR(count.mean(), 0.2, 0.03);
}

TEST(LineOfSight, SaysHowMuchOfAVehicleIsHidden) {
  const LineOfSight sight(open_country(
      car(0, {}, 30), {car(1, {20, 0, 0}, 30), car(2, {60, 0, 0}, 30), car(3, {40, 1.8, 0}, 30)}));
  EXPECT_EQ(sight.hidden_share(1), 0);
  EXPECT_NEAR(sight.hidden_share(2), 1, 1e-12);
  // The near one's shadow reaches to 1.8 m at 40 m: to the middle of the third one's rear.
  EXPECT_NEAR(sight.hidden_share(3), 0.5, 0.06);
  EXPECT_EQ(sight.hidden_share(9), 1);
}

TEST(LineOfSight, LooksFromWhereTheSensorIs) {
  const Scene scene = open_country(car(0, {}, 30), {car(1, {20, 3, 0}, 30)});
  const Eigen::Vector2d target(60, 3);
  EXPECT_FALSE(LineOfSight(scene).blocked(target));
  EXPECT_TRUE(LineOfSight(scene, {0, 3, 0}).blocked({60, 0}));
}

}  // namespace
}  // namespace lanefuse
