// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/image_truth.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "simulation/rendered_scene.hpp"

namespace lanefuse {
namespace {

using testing::clean_picture;
using testing::green;
using testing::RenderedScene;

/// A car, dark grey, whose rear is `x` [m] ahead of the ego car's front axle, in its lane or beside it.
SceneVehicle car_ahead(const Scene& scene, double x, double lateral) {
  SceneVehicle car;
  car.id = 7;
  car.station = scene.ego.station + x;
  car.lateral = lateral;
  car.world_from_vehicle = scene.road->pose(car.station, lateral);
  car.front = 4.5;
  car.width = 1.8;
  return car;
}

TEST(ImageTruth, MarkingsLieOnTheirRows) {
  const RenderedScene at(1);
  const CameraModel camera(high_resolution_camera_intrinsics());
  const ImageTruth truth(at.scene(), camera, at.mounting());
  int count = 0;
  for (const int line : truth.lines()) {
    for (int v = 370; v < 900; v += 7) {
      const auto there = truth.marking(line, v);
      if (!there) continue;
      ++count;
      EXPECT_NEAR(there->row, v, 1e-3);
      EXPECT_LT(there->left, there->column);
      EXPECT_LT(there->column, there->right);
      const auto again = truth.pixel(there->station, at.scene().road->line_lateral(line, there->station));
      ASSERT_TRUE(again);
      EXPECT_NEAR(again->x(), there->column, 1e-6);
      EXPECT_EQ(there->painted, at.scene().road->painted(line, there->station));
    }
  }
  EXPECT_GT(count, 150);
}

TEST(ImageTruth, SaysNearlyTheSameAsItsPose) {
  // The pose's one vertical curvature is all that a camera can know; near the car it must do.
  const RenderedScene at(2);
  const CameraModel camera(high_resolution_camera_intrinsics());
  const ImageTruth truth(at.scene(), camera, at.mounting());
  const GroundProjection known(camera, truth.pose());
  for (const int line : truth.lines()) {
    for (int v = 450; v < 900; v += 25) {
      const auto there = truth.marking(line, v);
      if (!there) continue;
      const auto ground = known.ground({there->column, there->row});
      ASSERT_TRUE(ground);
      EXPECT_NEAR(ground->x() / there->ground.x(), 1, 0.02);
      EXPECT_NEAR(ground->y(), there->ground.y(), 0.02 * std::abs(there->ground.y()) + 0.01);
    }
  }
}

TEST(ImageTruth, VehiclesHideWhatIsBehindThem) {
  RenderedScene at(1);
  const int line = *at.scene().road->lane_at(at.scene().ego.station, at.scene().ego.lateral);
  const double lateral = at.scene().road->line_lateral(line, at.scene().ego.station);
  at.scene().vehicles = {car_ahead(at.scene(), 20, lateral)};
  const CameraModel camera(serial_camera_intrinsics());
  const ImageTruth truth(at.scene(), camera, at.mounting());
  const double here = at.scene().ego.station;
  EXPECT_FALSE(truth.marking_at(line, here + 15)->hidden);
  EXPECT_TRUE(truth.marking_at(line, here + 22)->hidden);
  EXPECT_TRUE(truth.marking_at(line, here + 45)->hidden);
  EXPECT_FALSE(truth.marking_at(line + 1, here + 45)->hidden);
}

TEST(ImageTruth, BoxesHoldTheRenderedVehicle) {
  RenderedScene at(1);
  at.scene().vehicles.clear();
  const CameraRenderer renderer(serial_camera_intrinsics(), clean_picture());
  const Image empty = renderer.render(at.scene(), at.mounting());
  at.scene().vehicles = {car_ahead(at.scene(), 25, at.scene().ego.lateral)};
  const Image image = renderer.render(at.scene(), at.mounting());
  const auto boxes = ImageTruth(at.scene(), renderer.camera(), at.mounting()).vehicles();
  ASSERT_EQ(boxes.size(), 1u);
  const VehicleBox& box = boxes.front();
  EXPECT_NEAR(box.distance, 25, 0.3);
  EXPECT_NEAR(box.width, 1.8, 1e-9);
  EXPECT_EQ(box.confidence, 1);
  // Above the wheels, where its shadow is not, the picture changed in the box alone, and up to its sides.
  const int v = static_cast<int>((box.top + 2 * box.bottom) / 3);
  int first = image.width(), last = 0;
  for (int u = 0; u < image.width(); ++u) {
    if (std::abs(green(image, u, v) - green(empty, u, v)) < 8) continue;
    first = std::min(first, u);
    last = std::max(last, u);
  }
  EXPECT_NEAR(first, box.left, 3);
  EXPECT_NEAR(last, box.right, 3);
}

TEST(ImageTruth, AVehicleBesideTheCameraReachesToTheBorder) {
  RenderedScene at(1);
  at.scene().vehicles = {car_ahead(at.scene(), -2, at.scene().ego.lateral + 3.2)};
  const CameraModel camera(serial_camera_intrinsics());
  const ImageTruth truth(at.scene(), camera, at.mounting());
  // Its front, 2.5 m ahead and 3.2 m aside, is beyond the image's border; a longer one is not.
  EXPECT_TRUE(truth.vehicles().empty());
  at.scene().vehicles.front().front = 16;
  const auto boxes = ImageTruth(at.scene(), camera, at.mounting()).vehicles();
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes.front().left, -0.5);
  EXPECT_EQ(boxes.front().bottom, 639.5);
  EXPECT_GT(boxes.front().right, 100);
}

TEST(ImageTruth, NearerVehiclesCoverFartherOnes) {
  RenderedScene at(1);
  SceneVehicle near = car_ahead(at.scene(), 15, at.scene().ego.lateral);
  SceneVehicle far = car_ahead(at.scene(), 60, at.scene().ego.lateral);
  at.scene().vehicles = {far, near};
  const CameraModel camera(serial_camera_intrinsics());
  const auto boxes = ImageTruth(at.scene(), camera, at.mounting()).vehicles();
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_LT(boxes[0].distance, boxes[1].distance);
  EXPECT_EQ(boxes[0].confidence, 1);
  EXPECT_LT(boxes[1].confidence, 0.3);
}

}  // namespace
}  // namespace lanefuse
