// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "objects/radar_tracker.hpp"
#include "support/radar_scene.hpp"

namespace lanefuse {
namespace {

using testing::RadarCar;
using testing::RoadUser;

/// A tracker and the car that carries it.
struct Drive {
  RadarCar car;
  RadarTracker tracker{RadarTrackerConfig{}};

  bool take(const RadarScan& scan, double seconds) {
    return tracker.update(scan, {car.radar_pose(seconds), car.radar_velocity(seconds)});
  }
  std::vector<TrackedObject> see(const std::vector<RoadUser>& users, double seconds) {
    EXPECT_TRUE(take(car.scan(users, seconds), seconds));
    return tracker.tracks(car.pose(seconds));
  }
};

constexpr int kFourSeconds = 80;
constexpr double seconds_of(int scan) { return scan * testing::kScanPeriod; }

/// How far a track's position is from where the vehicle truly is.
double error(const TrackedObject& object, const RoadUser& user, const RadarCar& car, double seconds) {
  return (car.pose(seconds) * Eigen::Vector2d(object.x, object.y) - user.at(seconds)).norm();
}

class TracksFromAnyMounting : public ::testing::TestWithParam<Pose2> {};

TEST_P(TracksFromAnyMounting, AVehicleAheadExactlyWithoutNoise) {
  Drive drive{{30, 0.03, GetParam()}};
  const RoadUser user{{45, 6}, {28, 1.5}};
  std::vector<TrackedObject> objects;
  for (int i = 0; i <= kFourSeconds; ++i) objects = drive.see({user}, seconds_of(i));
  const double end = seconds_of(kFourSeconds);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_LT(error(objects[0], user, drive.car, end), 0.02);
  EXPECT_NEAR(objects[0].speed, user.velocity.norm(), 0.02);
  const double heading = std::atan2(user.velocity.y(), user.velocity.x()) - drive.car.pose(end).heading;
  EXPECT_NEAR(objects[0].heading, heading, 0.002);
  EXPECT_EQ(objects[0].movement, MovementState::moving);
  EXPECT_TRUE(objects[0].seen_by_radar);
  EXPECT_FALSE(objects[0].seen_by_camera);
}

INSTANTIATE_TEST_SUITE_P(Mountings, TracksFromAnyMounting,
                         ::testing::Values(Pose2{}, Pose2{3.6, 0, 0}, Pose2{3.2, 0.8, 0.7},
                                           Pose2{-1, -0.9, -0.4}));

TEST(RadarTracker, IsBetterThanItsMeasurementsAndKeepsOneId) {
  Drive drive;
  testing::RadarNoise noise;
  const RoadUser user{{60, 2}, {31, 0.3}};
  double measured = 0;
  double tracked = 0;
  std::set<std::int64_t> ids;
  for (int i = 0; i < 400; ++i) {
    const double seconds = seconds_of(i);
    RadarScan scan = drive.car.scan({}, seconds);
    scan.detections.push_back(noise(drive.car.detect(user, seconds)));
    ASSERT_TRUE(drive.take(scan, seconds));
    if (i < 40) continue;
    const auto objects = drive.tracker.tracks(drive.car.pose(seconds));
    ASSERT_EQ(objects.size(), 1U);
    ids.insert(objects[0].id);
    const auto& seen = scan.detections[0];
    const Eigen::Vector2d in_radar =
        seen.range * Eigen::Vector2d(std::cos(seen.bearing), std::sin(seen.bearing));
    measured += (drive.car.radar_pose(seconds) * in_radar - user.at(seconds)).squaredNorm();
    tracked += std::pow(error(objects[0], user, drive.car, seconds), 2);
  }
  EXPECT_LT(tracked, 0.25 * measured) << "half the noise is gone at least";
  EXPECT_EQ(ids.size(), 1U);
}

TEST(RadarTracker, StatesAnUncertaintyThatFitsItsErrors) {
  Drive drive;
  testing::RadarNoise noise;
  const RoadUser user{{60, 2}, {31, 0.3}};
  double squares = 0;
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    const double seconds = seconds_of(i);
    RadarScan scan = drive.car.scan({}, seconds);
    scan.detections.push_back(noise(drive.car.detect(user, seconds)));
    drive.take(scan, seconds);
    for (const TrackedObject& object : drive.tracker.tracks(drive.car.pose(seconds))) {
      const Eigen::Vector2d truth = drive.car.pose(seconds).inverse() * user.at(seconds);
      const Eigen::Vector2d off = Eigen::Vector2d(object.x, object.y) - truth;
      squares += off.dot(object.covariance.topLeftCorner<2, 2>().inverse() * off);
      ++count;
    }
  }
  EXPECT_LT(squares / count, 2.0) << "two degrees of freedom: not overconfident";
  EXPECT_GT(squares / count, 0.1) << "nor useless";
}

TEST(RadarTracker, TellsWhatStandsFromWhatDrives) {
  Drive drive{{30, 0.0}};
  const std::vector<RoadUser> users{{{150, -6}, {0, 0}}, {{300, 7}, {-30, 0}}, {{40, 0}, {30, 0}}};
  std::vector<TrackedObject> objects;
  for (int i = 0; i <= 40; ++i) objects = drive.see(users, seconds_of(i));
  ASSERT_EQ(objects.size(), 3U);
  EXPECT_EQ(objects[0].movement, MovementState::stationary) << "a sign post";
  EXPECT_LT(objects[0].speed, 1);
  EXPECT_EQ(objects[1].movement, MovementState::moving) << "oncoming";
  EXPECT_NEAR(std::abs(objects[1].heading), std::numbers::pi, 0.05);
  EXPECT_NEAR(objects[1].speed, 30, 0.5);
  EXPECT_EQ(objects[2].movement, MovementState::moving) << "ahead";
  EXPECT_NEAR(objects[2].heading, 0, 0.01);
}

TEST(RadarTracker, KeepsTwoNeighboursApart) {
  Drive drive{{30, 0.0}};
  testing::RadarNoise noise;
  const std::vector<RoadUser> users{{{50, 1.75}, {30, 0}}, {{50, -1.75}, {30, 0}}};
  for (int i = 0; i < 200; ++i) {
    RadarScan scan = drive.car.scan(users, seconds_of(i));
    for (RadarDetection& detection : scan.detections) detection = noise(detection);
    if (i % 2 == 1) std::swap(scan.detections[0], scan.detections[1]);
    if (i > 20 && i % 5 == 0) scan.detections.pop_back();
    drive.take(scan, seconds_of(i));
    if (i < 12) continue;
    const auto objects = drive.tracker.tracks(drive.car.pose(seconds_of(i)));
    ASSERT_EQ(objects.size(), 2U) << "scan " << i;
    EXPECT_EQ(objects[0].id, 1);
    EXPECT_EQ(objects[1].id, 2);
    EXPECT_GT(objects[0].y, 0.5);
    EXPECT_LT(objects[1].y, -0.5);
  }
}

TEST(RadarTracker, TakesSeveralReflectionsOfAVehicleForOne) {
  Drive drive;
  const std::vector<RoadUser> rear{{{50, 0.4}, {30, 0}}, {{50.8, -0.4}, {30, 0}}, {{51, 0}, {30, 0}}};
  std::vector<TrackedObject> objects;
  for (int i = 0; i <= 40; ++i) objects = drive.see(rear, seconds_of(i));
  EXPECT_EQ(objects.size(), 1U);
}

}  // namespace
}  // namespace lanefuse
