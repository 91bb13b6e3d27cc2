// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/object_list_model.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::Moments;
using testing::SceneRun;

/// The vehicle that a track follows, seen from the ego car.
Pose2 truth_of(const Scene& scene, const TrackedObject& object) {
  Pose2 nearest{INFINITY, INFINITY, 0};
  const Eigen::Vector2d seen(object.x, object.y);
  for (const SceneVehicle& vehicle : scene.vehicles) {
    const Pose2 pose = scene.ego.world_from_vehicle.inverse() * vehicle.world_from_vehicle;
    if ((pose.position() - seen).norm() < (nearest.position() - seen).norm()) nearest = pose;
  }
  return nearest;
}

TEST(ObjectListModel, ErrsAsThePresetSays) {
  const double degree = std::numbers::pi / 180;
  std::map<int, Moments> lateral;  // by 50 m, in units of the expected sigma
  Moments along, heading;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SceneRun run(seed);
    ObjectListModel model(run.preset(), seed);
    run.watch(model, 60, [&](const Scene& scene, const Measurement& measurement) {
      for (const TrackedObject& object : std::get<ObjectList>(measurement).objects) {
        const Pose2 truth = truth_of(scene, object);
        const double range = truth.position().norm();
        if (truth.x < 0) continue;
        const double sigma = std::hypot(0.2 + 0.1 * range / 100, 0.08 * degree * truth.x);
        lateral[static_cast<int>(range / 50)].add((object.y - truth.y) / sigma);
        along.add(object.x - truth.x);
        heading.add((object.heading - truth.heading) / degree);
        EXPECT_NEAR(object.covariance(1, 1), std::pow(0.2 + 0.1 * range / 100, 2), 1e-9);
        EXPECT_EQ(object.covariance(0, 1), 0);
      }
    });
  }
  for (const auto& [distance, error] : lateral) {
    EXPECT_GT(error.count(), 3000);
    EXPECT_NEAR(error.rms(), 1, 0.2) << "from " << distance * 50 << " m";
  }
  EXPECT_EQ(lateral.size(), 3u);
  EXPECT_NEAR(along.rms(), 0.25, 0.05);
  EXPECT_NEAR(heading.rms(), 0.68, 0.1);  // rms of a uniform sigma in [0.4, 0.9], and of the misalignment
}

TEST(ObjectListModel, ErrorsLast) {
  std::map<std::int64_t, double> before;
  double products = 0, squares = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SceneRun run(seed);
    ObjectListModel model(run.preset(), seed);
    before.clear();
    run.watch(model, 100, [&](const Scene& scene, const Measurement& measurement) {
      for (const TrackedObject& object : std::get<ObjectList>(measurement).objects) {
        const Pose2 truth = truth_of(scene, object);
        const double error = (object.x - truth.x);
        if (const auto last = before.find(object.id); last != before.end()) {
          products += last->second * error;
          squares += error * error;
        }
        before[object.id] = error;
      }
    });
  }
  EXPECT_NEAR(products / squares, std::exp(-0.08 / 0.8), 0.03);
}

TEST(ObjectListModel, MissesTheHiddenAndVerifiesByCameraOnlyAheadAndNear) {
  double hidden = 0, far_unverified = 0, near = 0, near_verified = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SceneRun run(seed);
    ObjectListModel model(run.preset(), seed);
    std::set<std::int64_t> was_near;
    run.watch(model, 60, [&](const Scene& scene, const Measurement& measurement) {
      const LineOfSight sight(scene);
      const auto& objects = std::get<ObjectList>(measurement).objects;
      std::size_t expected = 0;
      for (const SceneVehicle& vehicle : scene.vehicles) {
        const Pose2 pose = scene.ego.world_from_vehicle.inverse() * vehicle.world_from_vehicle;
        const bool in_reach = pose.position().norm() < (pose.x > 0 ? 150 : 50);
        const bool blocked = sight.blocked(pose.position(), vehicle.id);
        hidden += in_reach && blocked;
        expected += in_reach && !blocked;
      }
      ASSERT_EQ(objects.size(), expected);
      for (const TrackedObject& object : objects) {
        EXPECT_TRUE(object.seen_by_radar);
        const bool is_near = object.x > 10 && std::abs(object.y) < 6 && object.x < 88;
        if (object.x > 0 && std::hypot(object.x, object.y) < 92) was_near.insert(object.id);
        near += is_near;
        near_verified += is_near && object.seen_by_camera;
        far_unverified += object.x > 95 && !object.seen_by_camera;
        const bool verified_far = object.seen_by_camera && object.x > 95;
        ASSERT_TRUE(!verified_far || was_near.contains(object.id));
      }
    });
  }
  EXPECT_GT(hidden, 100);
  EXPECT_GT(far_unverified, 100);
  EXPECT_GT(near_verified / near, 0.97);
}

}  // namespace
}  // namespace lanefuse
