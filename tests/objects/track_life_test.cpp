// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "objects/radar_tracker.hpp"
#include "support/radar_scene.hpp"

namespace lanefuse {
namespace {

using testing::kScanPeriod;
using testing::RadarCar;
using testing::RoadUser;

class TrackLife : public ::testing::Test {
 protected:
  /// The next scan, a period later: of these vehicles with these slots of the radar's own tracker.
  std::vector<TrackedObject> scan(const std::vector<RoadUser>& users,
                                  std::optional<std::int32_t> address = {}, bool new_track = false) {
    seconds_ += kScanPeriod;
    RadarScan scan = car_.scan(users, seconds_);
    for (RadarDetection& detection : scan.detections) {
      detection.address = address;
      detection.new_track = new_track;
    }
    EXPECT_TRUE(tracker_.update(scan, {car_.radar_pose(seconds_), car_.radar_velocity(seconds_)}));
    return tracker_.tracks(car_.pose(seconds_));
  }
  std::vector<TrackedObject> scans(int count, const std::vector<RoadUser>& users) {
    std::vector<TrackedObject> objects;
    for (int i = 0; i < count; ++i) objects = scan(users);
    return objects;
  }

  RadarCar car_{30, 0};
  RadarTracker tracker_{RadarTrackerConfig{}};
  double seconds_ = 0;
  const RoadUser user_{{50, 0}, {29, 0}};
};

TEST_F(TrackLife, BeginsAfterTenScans) {
  EXPECT_TRUE(scans(9, {user_}).empty());
  EXPECT_EQ(scan({user_}).size(), 1U);
}

TEST_F(TrackLife, GoesOnUnseenForHalfASecond) {
  const auto seen = scans(40, {user_});
  ASSERT_EQ(seen.size(), 1U);
  const auto unseen = scans(10, {});
  ASSERT_EQ(unseen.size(), 1U);
  EXPECT_EQ(unseen[0].id, seen[0].id);
  const Eigen::Vector2d truth = car_.pose(seconds_).inverse() * user_.at(seconds_);
  EXPECT_NEAR(unseen[0].x, truth.x(), 0.1) << "it moves on as it did";
  EXPECT_GT(unseen[0].covariance(0, 0), seen[0].covariance(0, 0));
  EXPECT_TRUE(scan({}).empty());
}

TEST_F(TrackLife, IsTheSameAfterAShortGap) {
  const auto before = scans(40, {user_});
  scans(8, {});
  const auto after = scans(3, {user_});
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].id, before[0].id);
}

TEST_F(TrackLife, EndsSoonWhereItNeverWasConfirmed) {
  scans(9, {user_});
  scans(5, {});
  EXPECT_TRUE(scan({user_}).empty()) << "the nine hits are forgotten";
}

TEST_F(TrackLife, StartsAnewWhenTheRadarsSlotIsTakenAnew) {
  const RoadUser first{{50, 1.75}, {30, 0}};
  const RoadUser second{{50, -1.75}, {30, 0}};
  std::vector<TrackedObject> objects;
  for (int i = 0; i < 20; ++i) objects = scan({first}, 5);
  ASSERT_EQ(objects.size(), 1U);
  const std::int64_t id = objects[0].id;
  scan({second}, 5, true);
  for (int i = 0; i < 15; ++i) objects = scan({second}, 5);
  ASSERT_EQ(objects.size(), 1U) << "the first has been forgotten by now";
  EXPECT_NE(objects[0].id, id);
  EXPECT_LT(objects[0].y, -1);
}

TEST_F(TrackLife, TheRadarsSlotHoldsATrackThatJumps) {
  std::vector<TrackedObject> objects;
  for (int i = 0; i < 20; ++i) objects = scan({user_}, 5);
  const std::int64_t id = objects[0].id;
  const RoadUser jumped{user_.start + Eigen::Vector2d(0, 2.6), user_.velocity};
  for (int i = 0; i < 20; ++i) objects = scan({jumped}, 5);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].id, id);
}

TEST_F(TrackLife, RefusesScansFromThePast) {
  scans(20, {user_});
  const RadarScan late = car_.scan({user_}, seconds_ - kScanPeriod);
  const auto before = tracker_.tracks(car_.pose(seconds_));
  EXPECT_FALSE(tracker_.update(late, {car_.radar_pose(seconds_), car_.radar_velocity(seconds_)}));
  const auto after = tracker_.tracks(car_.pose(seconds_));
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(after[0].x, before[0].x);
}

TEST_F(TrackLife, TakesTwoRadarsOfOneMoment) {
  scans(20, {user_});
  const RadarScan other = car_.scan({user_}, seconds_);
  EXPECT_TRUE(tracker_.update(other, {car_.radar_pose(seconds_), car_.radar_velocity(seconds_)}));
  EXPECT_EQ(tracker_.tracks(car_.pose(seconds_)).size(), 1U);
}

TEST_F(TrackLife, ResetIsABeginning) {
  scans(20, {user_});
  tracker_.reset();
  EXPECT_TRUE(tracker_.tracks(car_.pose(seconds_)).empty());
  seconds_ -= 10 * kScanPeriod;
  const auto objects = scans(10, {user_});
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].id, 1);
}

}  // namespace
}  // namespace lanefuse
