// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <gtest/gtest.h>

#include "simulation/detection_scene.hpp"
#include "simulation/high_resolution_camera_model.hpp"
#include "simulation/object_list_model.hpp"
#include "simulation/scene_run.hpp"
#include "simulation/serial_camera_model.hpp"
#include "simulation/simulated_drive.hpp"
#include "simulation/varied_road.hpp"

namespace lanefuse {
namespace {

using testing::SceneRun;
using testing::VariedRoad;

/// An empty road with the ego car on it.
Scene scene_on(const Road& road, double station, double lateral) {
  Scene scene;
  scene.road = &road;
  scene.ego = testing::car(0, road.pose(station, lateral), 30);
  scene.ego.station = station;
  scene.ego.lateral = lateral;
  return scene;
}

/// The road with its line of that number, too, painted a second time at `lateral`.
Road with_double(const Road& road, int line, double lateral, bool ghost) {
  RoadParts parts = road.parts();
  RoadLine another = parts.lines[static_cast<std::size_t>(line)];
  another.lateral = LateralCourse(lateral);
  another.ghost = ghost;
  parts.lines.push_back(another);
  return {road.reference(), road.height(), std::move(parts)};
}

/// What a camera saw of some frames at one place.
std::vector<Feature> markings_at(const Scene& scene, const SensorPreset& preset, int frames) {
  HighResolutionCameraModel camera(preset, 1);
  std::vector<Feature> features;
  for (int i = 0; i < frames; ++i) {
    const auto seen = testing::look<MarkingFeatures>(camera, scene).features;
    features.insert(features.end(), seen.begin(), seen.end());
  }
  return features;
}

TEST(LineLabels, MarkingsNameTheLineThatTheyLieOn) {
  SensorPreset preset = nominal_preset();
  preset.camera_pose.residual_pitch = 0;  // which moves what is beside the road along its ray
  double all = 0, paint = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SceneRun run(seed);
    HighResolutionCameraModel camera(preset, seed);
    run.watch(camera, 30, [&](const Scene& scene, const Measurement& measurement) {
      for (const Feature& feature : std::get<MarkingFeatures>(measurement).features) {
        all += 1;
        ASSERT_NE(feature.label, kNoLabel);
        if (feature.label == kNoLine) continue;
        paint += 1;
        ASSERT_LT(feature.label, scene.road->line_count());
        if (feature.x > 40) continue;  // further away its errors may carry it to the next line
        const Eigen::Vector2d place = testing::place_of(scene, {feature.x, feature.y});
        ASSERT_NEAR(place.y(), scene.road->line_lateral(feature.label, place.x()), 0.8);
      }
    });
  }
  EXPECT_GT(all, 10'000);
  // Of the bars that are looked for 5 % are outliers; those beyond the field of view are not seen.
  EXPECT_NEAR(paint / all, 0.95, 0.01);
}

TEST(LineLabels, OfOutliersAndGhostsIsNoLine) {
  SensorPreset preset = nominal_preset();
  preset.high_resolution_camera.outliers = 1;
  const Road road = VariedRoad::make(1);
  for (const Feature& feature : markings_at(scene_on(road, 100, 0), preset, 20))
    ASSERT_EQ(feature.label, kNoLine);

  preset.high_resolution_camera.outliers = 0;
  const Road haunted = with_double(road, 2, 1.2, true);
  int on_ghost = 0;
  for (const Feature& feature : markings_at(scene_on(haunted, 100, -1.8), preset, 50)) {
    if (feature.x > 30) continue;
    const bool ghost = std::abs(feature.y - (1.2 + 1.8)) < 0.5;
    on_ghost += ghost;
    ASSERT_EQ(feature.label == kNoLine, ghost) << feature.x << ", " << feature.y;
  }
  EXPECT_GT(on_ghost, 50);
}

TEST(LineLabels, DrawNothing) {
  const SensorPreset preset = nominal_preset();
  const Road plain = with_double(VariedRoad::make(1), 2, 1.2, false);
  const Road haunted = with_double(VariedRoad::make(1), 2, 1.2, true);
  const auto a = markings_at(scene_on(plain, 100, -1.8), preset, 20);
  const auto b = markings_at(scene_on(haunted, 100, -1.8), preset, 20);
  ASSERT_EQ(a.size(), b.size());
  int labelled_otherwise = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::pair(a[i].x, a[i].y), std::pair(b[i].x, b[i].y));
    labelled_otherwise += a[i].label != b[i].label;
  }
  EXPECT_GT(labelled_otherwise, 0);
}

TEST(LineLabels, SerialCameraNamesTheLinesBesideTheCar) {
  int changes = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SceneRun run(seed);
    SerialCameraModel camera(run.preset(), seed);
    int lane_before = 1;
    run.watch(camera, 150, [&](const Scene& scene, const Measurement& measurement) {
      const int lane = *scene.road->lane_at(scene.ego.station, scene.ego.lateral);
      changes += std::exchange(lane_before, lane) != lane;
      const auto& seen = std::get<SerialLane>(measurement);
      ASSERT_TRUE(!seen.left || seen.left->label == lane);
      ASSERT_TRUE(!seen.right || seen.right->label == lane + 1);
    });
  }
  EXPECT_GE(changes, 3);
}

using Labels = std::pair<LineLabel, LineLabel>;

/// What the object list says of a car 40 m ahead of the ego car, which drives in the middle of the road.
Labels labels_of_car(const Road& road, double station, double lateral) {
  Scene scene = scene_on(road, station - 40, 0);
  scene.vehicles = {testing::car(1, road.pose(station, lateral), 30)};
  scene.vehicles[0].station = station;
  scene.vehicles[0].lateral = lateral;
  ObjectListModel model(nominal_preset(), 1);
  const auto objects = testing::look<ObjectList>(model, scene).objects;
  return {objects.at(0).left_label, objects.at(0).right_label};
}

TEST(LineLabels, ObjectsNameTheLinesOfTheirLane) {
  const Road road = VariedRoad::make(1);
  EXPECT_EQ(labels_of_car(road, 500, 5.4), Labels(0, 1));
  EXPECT_EQ(labels_of_car(road, 500, 1.8), Labels(1, 2));
  EXPECT_EQ(labels_of_car(road, 500, -5.8), Labels(3, 4));
  EXPECT_EQ(labels_of_car(road, 2700, -9), Labels(4, 5)) << "on the entry lane";
  EXPECT_EQ(labels_of_car(road, 3700, -9), Labels(4, 6)) << "on the exit lane";
  EXPECT_EQ(labels_of_car(road, 4600, 3.8), Labels(1, 2)) << "where lanes have moved aside";
}

TEST(LineLabels, ObjectsBetweenLanesNameNone) {
  const Road road = VariedRoad::make(1);
  EXPECT_EQ(labels_of_car(road, 500, 1.8 + 0.85), Labels(1, 2));
  EXPECT_EQ(labels_of_car(road, 500, 1.8 + 0.95), Labels(kNoLine, kNoLine));
  EXPECT_EQ(labels_of_car(road, 500, 1.8 - 0.95), Labels(kNoLine, kNoLine));
  EXPECT_EQ(labels_of_car(road, 2000, 5.4), Labels(kNoLine, kNoLine)) << "its lane has ended";
}

TEST(LineLabels, WithoutARoadNobodySays) {
  Scene scene = testing::open_country(testing::car(0, {}, 30), {testing::car(1, {40, 0, 0}, 30)});
  ObjectListModel model(nominal_preset(), 1);
  const auto objects = testing::look<ObjectList>(model, scene).objects;
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].left_label, kNoLabel);
  EXPECT_EQ(objects[0].right_label, kNoLabel);
}

TEST(LineLabels, ADriveHandsThemOut) {
  SimulationConfig config = testing::short_drive(3);
  config.scenario = built_in_scenario("construction-zone");
  bool markings = false, lanes = false, objects = false;
  for (const Measurement& measurement : testing::drive(config).measurements) {
    if (const auto* seen = std::get_if<MarkingFeatures>(&measurement)) {
      for (const Feature& feature : seen->features) markings |= feature.label >= 0;
    } else if (const auto* lane = std::get_if<SerialLane>(&measurement)) {
      lanes |= lane->left && lane->left->label >= 0;
    } else if (const auto* list = std::get_if<ObjectList>(&measurement)) {
      for (const TrackedObject& object : list->objects) objects |= object.left_label >= 0;
    }
  }
  EXPECT_TRUE(markings && lanes && objects);
}

}  // namespace
}  // namespace lanefuse
