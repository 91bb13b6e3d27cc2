// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/tracking_trial.hpp"

#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "benchmark/nearest_neighbour.hpp"
#include "evaluation/tracking_json.hpp"
#include "support/radar_scene.hpp"

namespace lanefuse {
namespace {

using testing::RadarCar;
using testing::RoadUser;

TrackingTrialFigures run_short(std::uint64_t seed) {
  TrackingTrial trial;
  trial.seed = seed;
  trial.km = 0.3;
  return run_trial(trial, [](double) {});
}

TEST(TrackingTrial, JudgesBothTrackersInTheSameCycles) {
  const TrackingTrialFigures figures = run_short(1);
  EXPECT_GT(figures.fused.frames, 90U);  // 10 s at 12.5 Hz, but for the ends
  EXPECT_EQ(figures.fused.frames, figures.nearest_neighbour.frames);
  EXPECT_NEAR(figures.fused.hours, static_cast<double>(figures.fused.frames - 1) / 12.5 / 3600, 1e-9);
  EXPECT_EQ(figures.fused.all.vehicles, figures.nearest_neighbour.all.vehicles);
  EXPECT_GT(figures.fused.all.hits, 0U);
}

TEST(TrackingTrial, GivesTheSameTwiceAndOtherwiseForAnotherSeed) {
  const auto said = [](std::uint64_t seed) { return to_json(run_short(seed).fused).dump(); };
  EXPECT_EQ(said(1), said(1));
  EXPECT_NE(said(1), said(2));
}

TEST(TrackingTrial, LongWaysAreCutIntoDrivesOfTheirOwn) {
  TrackingTrial whole;
  whole.seed = 3;
  whole.km = 60;
  whole.guard_rail_mirrors = 4;
  const auto pieces = cut_trial(whole);
  ASSERT_EQ(pieces.size(), 3U);
  std::set<std::uint64_t> seeds;
  double km = 0;
  for (const TrackingTrial& piece : pieces) {
    seeds.insert(piece.seed);
    km += piece.km;
    EXPECT_LE(piece.km, kTrialKm);
    EXPECT_EQ(piece.guard_rail_mirrors, 4);
  }
  EXPECT_EQ(seeds.size(), 3U);
  EXPECT_EQ(pieces.front().seed, 3U);
  EXPECT_NEAR(km, 60, 1e-9);
  whole.km = 24;
  EXPECT_EQ(cut_trial(whole).size(), 1U);
}

/// The dead reckoning of a car up to a moment.
std::vector<MotionSample> motion_until(const RadarCar& car, double end) {
  std::vector<MotionSample> samples;
  for (double seconds = 0; seconds < end + 1e-6; seconds += 0.02)
    samples.push_back({testing::scan_time(seconds), car.pose(seconds), car.speed, car.yaw_rate});
  return samples;
}

TEST(NearestNeighbour, MovesItsTracksToTheCycle) {
  const Rig rig{{{1, SensorKind::long_range_radar, "radar", {.x = 3.6}}}};
  const RadarCar car{30, 0.03, {3.6, 0, 0}};
  const std::vector<RoadUser> users{{{45, 6}, {28, 1.5}}, {{60, -8}, {0, 0}}};
  NearestNeighbour tracker(rig);
  double seconds = 0;
  for (; seconds < 3; seconds += testing::kScanPeriod) {
    tracker.add(car.scan(users, seconds), motion_until(car, seconds));
  }
  const double now = seconds + 0.03;
  const auto objects = tracker.objects(testing::scan_time(now), motion_until(car, now));
  ASSERT_EQ(objects.size(), 1U);  // not the one that stands
  const Eigen::Vector2d place = car.pose(now).inverse() * users[0].at(now);
  EXPECT_NEAR(objects[0].x, place.x(), 0.05);
  EXPECT_NEAR(objects[0].y, place.y(), 0.05);
  EXPECT_TRUE(objects[0].witness);
}

}  // namespace
}  // namespace lanefuse
