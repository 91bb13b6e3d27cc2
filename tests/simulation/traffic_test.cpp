// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/traffic.hpp"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::Moments;
using testing::SceneRun;

bool overlap(const SceneVehicle& a, const SceneVehicle& b) {
  const bool along = a.station + a.front > b.station - b.rear && b.station + b.front > a.station - a.rear;
  return along && std::abs(a.lateral - b.lateral) < (a.width + b.width) / 2;
}

TEST(Traffic, NeverCollidesAndKeepsToItsLanes) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SceneRun run(seed, seed % 2 ? RoadKind::gentle : RoadKind::curved);
    for (int tick = 0; tick < 60 * 50; ++tick, run.advance()) {
      std::vector<SceneVehicle> all = run.scene().vehicles;
      all.push_back(run.scene().ego);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Vehicle& driver = run.traffic().vehicles()[i == all.size() - 1 ? 0 : i + 1];
        ASSERT_EQ(driver.id, all[i].id);
        const double off = std::abs(all[i].lateral - run.road().lane_centre(all[i].lane, all[i].station));
        ASSERT_TRUE(driver.lateral.changing() || off + all[i].width / 2 <= run.road().lane_width() / 2);
        for (std::size_t j = 0; j < i; ++j) ASSERT_FALSE(overlap(all[i], all[j])) << "seed " << seed;
      }
    }
  }
}

TEST(Traffic, IsAsDenseAsThePresetSays) {
  Moments vehicles;
  double trucks = 0, seen = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SceneRun run(seed);
    for (int second = 0; second < 240; ++second) {
      vehicles.add(static_cast<double>(run.traffic().vehicles().size()) - 1);
      for (const Vehicle& vehicle : run.traffic().vehicles()) trucks += vehicle.truck;
      seen += static_cast<double>(run.traffic().vehicles().size());
      for (int tick = 0; tick < 50; ++tick) run.advance();
    }
  }
  EXPECT_NEAR(vehicles.mean(), 8 * 0.6 * 3, 1.5);
  EXPECT_NEAR(trucks / seen, 0.15, 0.04);
}

TEST(Traffic, ChangesLanesAsOftenAsThePresetSays) {
  double seconds = 0, changes = 0, ego_changes = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SceneRun run(seed);
    std::map<std::int64_t, int> lanes;
    for (int tick = 0; tick < 270 * 50; ++tick, run.advance()) {
      for (const Vehicle& vehicle : run.traffic().vehicles()) {
        const auto [entry, first] = lanes.try_emplace(vehicle.id, vehicle.lane);
        const bool changed = entry->second != vehicle.lane;
        ASSERT_LE(std::abs(entry->second - vehicle.lane), 1);
        ASSERT_FALSE(changed && vehicle.truck);
        entry->second = vehicle.lane;
        (vehicle.id == kEgoId ? ego_changes : changes) += changed;
        if (vehicle.id != kEgoId) seconds += 0.02;
      }
    }
  }
  EXPECT_NEAR(seconds / changes, 50, 10);
  EXPECT_GE(ego_changes, 8 * 2);  // at 90 s and 180 s; some wait long for a gap
  EXPECT_LE(ego_changes, 8 * 3);
}

TEST(Traffic, WandersAsThePresetSays) {
  Moments off;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SceneRun run(seed);
    for (int tick = 0; tick < 120 * 50; ++tick, run.advance()) {
      if (tick % 100 != 0) continue;
      for (const Vehicle& vehicle : run.traffic().vehicles()) {
        if (vehicle.id == kEgoId || vehicle.truck || vehicle.lateral.changing()) continue;
        off.add(vehicle.lateral.state().position - run.road().lane_centre(vehicle.lane, vehicle.station));
      }
    }
  }
  EXPECT_NEAR(off.mean(), 0, 0.03);
  EXPECT_NEAR(off.sigma(), std::hypot(0.25, 0.15), 0.02);
}

TEST(Traffic, NeverGivesAnIdTwiceOrJumps) {
  SceneRun run(4);
  std::set<std::int64_t> gone;
  std::map<std::int64_t, double> before;
  for (int tick = 0; tick < 120 * 50; ++tick, run.advance()) {
    std::map<std::int64_t, double> now;
    for (const Vehicle& vehicle : run.traffic().vehicles()) {
      ASSERT_TRUE(now.emplace(vehicle.id, vehicle.station).second);
      ASSERT_FALSE(gone.contains(vehicle.id));
      ASSERT_LE(std::abs(vehicle.station - run.traffic().ego().station), kTrafficReach);
    }
    for (const auto& [id, station] : before) {
      if (!now.contains(id)) {
        gone.insert(id);
      } else {
        ASSERT_NEAR(now[id], station + 0.6, 0.6);
      }
    }
    before = now;
  }
  EXPECT_GT(gone.size(), 5u);
}

TEST(Vehicle, SpeedAndYawRateAreTheDerivativesOfItsPose) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SceneRun run(seed, RoadKind::curved);
    Moments speed, yaw_rate;
    for (int tick = 0; tick < 120 * 50; ++tick) {
      const SceneVehicle before = run.scene().ego;
      run.advance();
      const SceneVehicle after = run.scene().ego;
      const Pose2 step = before.world_from_vehicle.inverse() * after.world_from_vehicle;
      speed.add(step.x / 0.02 - (before.speed + after.speed) / 2);
      yaw_rate.add(step.heading / 0.02 - (before.yaw_rate + after.yaw_rate) / 2);
      ASSERT_LT(std::abs(step.y), 0.002);  // no slip
      ASSERT_LT(std::abs(after.yaw_rate - before.yaw_rate), 0.01);
    }
    EXPECT_LT(speed.rms(), 0.005);
    EXPECT_LT(yaw_rate.rms(), 1e-3);             // the wander's acceleration is rough from tick to tick
    EXPECT_LT(std::abs(yaw_rate.mean()), 1e-5);  // but nothing of it adds up
  }
}

TEST(CarFollowing, BrakesInTimeBehindAStandingCar) {
  const CarFollowing driver;
  double gap = 200, speed = 30;
  for (int i = 0; i < 6000; ++i) {
    speed = std::max(0.0, speed + 0.02 * driver.behind(speed, gap, 0));
    gap -= 0.02 * speed;
    ASSERT_GT(gap, 0);
  }
  EXPECT_LT(speed, 0.1);
  EXPECT_NEAR(gap, driver.standstill_gap, 1);
}

RC_GTEST_PROP(LateralMotion, SpeedAndAccelerationAreDerivatives, (std::uint64_t seed)) {
  Random random(seed, "test");
  LateralMotion motion(0, {0.25, 7, 0.1, 0.8}, random);
  motion.change_to({3.6});
  const double dt = 0.002;
  for (int i = 0; i < 3000; ++i) {
    const LateralMotion::State before = motion.state();
    motion.advance(dt, {}, random);
    const LateralMotion::State after = motion.state();
    RC_ASSERT(std::abs((after.position - before.position) / dt - (before.speed + after.speed) / 2) < 0.01);
    RC_ASSERT(std::abs((after.speed - before.speed) / dt - (before.acceleration + after.acceleration) / 2) <
              0.1);
    RC_ASSERT(std::abs(after.acceleration - before.acceleration) < 0.3);
  }
  RC_ASSERT(!motion.changing());
  RC_ASSERT(std::abs(motion.state().position - 3.6) <= 0.8);
}

}  // namespace
}  // namespace lanefuse
