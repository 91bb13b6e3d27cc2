// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/object_tracker.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "sources/witness.hpp"
#include "support/tracked_traffic.hpp"

namespace lanefuse {
namespace {

using testing::fused;
using testing::kLook;
using testing::moments;
using testing::nearest;
using testing::radar_only;
using testing::RoadUser;
using testing::TrackedTraffic;
using testing::TrafficScene;

std::set<std::int64_t> ids_of(const std::vector<TrackedObject>& objects) {
  std::set<std::int64_t> ids;
  for (const TrackedObject& object : objects) ids.insert(object.id);
  return ids;
}

TEST(ObjectTracker, FollowsAVehicleExactlyWithoutNoiseInACurve) {
  const TrafficScene scene{{30, 0.02}, {{{45, 2}, {28, 1}}}};
  TrackedTraffic traffic;
  std::vector<TrackedObject> objects;
  for (int i = 0; i <= 60; ++i) objects = traffic.radar(scene.at(i * kLook));
  const TrueFrame end = scene.at(60 * kLook);
  ASSERT_EQ(objects.size(), 1U);
  const Eigen::Vector2d truth = end.world_from_vehicle.inverse() * scene.users[0].at(60 * kLook);
  EXPECT_NEAR(objects[0].x, truth.x(), 0.1);
  EXPECT_NEAR(objects[0].y, truth.y(), 0.1);
  EXPECT_NEAR(objects[0].speed, scene.users[0].velocity.norm(), 0.1);
  EXPECT_NEAR(objects[0].heading, std::atan2(1, 28) - end.world_from_vehicle.heading, 0.01);
}

TEST(SightingMaker, SeesABoxUnderItsBearingAndInItsRange) {
  for (const double x : {15.0, 30.0, 60.0}) {
    const TrafficScene scene{{30, 0}, {{{x, 0}, {30, 0}}}};
    testing::DetectedTraffic detected;
    const TrueFrame frame = scene.at(0);
    const SightingSet look = TrackedTraffic::sightings(detected.boxes(frame), frame);
    ASSERT_EQ(look.sightings.size(), 1U);
    EXPECT_NEAR(look.sightings[0].bearing, 0, look.sightings[0].bearing_sigma);
    EXPECT_NEAR(look.sightings[0].range, x + 1.2, look.sightings[0].range_sigma) << "1.2 m behind the origin";
    ASSERT_TRUE(look.sightings[0].angular_width);
    EXPECT_NEAR(*look.sightings[0].angular_width * (x + 1.2), 1.9, 0.05);
  }
}

TEST(ObjectTracker, KeepsNeighboursAbreastApart) {
  const TrafficScene scene{{30, 0}, {{{40, 1.75}, {30, 0}}, {{40, -1.75}, {30, 0}}}};
  TrackedTraffic traffic(1);
  fused(traffic, scene, 0, 1);
  std::set<std::int64_t> left;
  std::set<std::int64_t> right;
  for (const double t : moments(1, 6)) {
    const TrueFrame frame = scene.at(t);
    const auto objects = traffic.both(frame);
    ASSERT_EQ(objects.size(), 2U) << t;
    for (const TrackedObject& object : objects) (object.y > 0 ? left : right).insert(object.id);
  }
  EXPECT_EQ(left.size(), 1U);
  EXPECT_EQ(right.size(), 1U);
  EXPECT_NE(left, right);
}

TEST(ObjectTracker, KeepsTheIdsOfVehiclesThatOvertakeOneAnother) {
  const TrafficScene scene{{30, 0}, {{{30, 1.75}, {36, 0}}, {{55, -1.75}, {30, 0}}}};
  TrackedTraffic traffic(1);
  const auto before = fused(traffic, scene, 0, 1.5);
  const auto after = fused(traffic, scene, 1.5, 7);
  ASSERT_EQ(before.size(), 2U);
  ASSERT_EQ(after.size(), 2U);
  for (const TrackedObject& object : after) {
    const auto same = std::ranges::find(before, object.id, &TrackedObject::id);
    ASSERT_NE(same, before.end());
    EXPECT_GT(same->y * object.y, 0) << "on its side of the line still";
  }
}

TEST(ObjectTracker, GivesEachOfTwoItsOwnWhereTheNearestWouldSwap) {
  // Both have moved to the left by 1.1 m: what the right one has become is nearest to where the left one was.
  const TrafficScene scene{{30, 0}, {{{40, 1}, {30, 0}}, {{40, -1}, {30, 0}}}};
  TrackedTraffic traffic;
  const auto before = radar_only(traffic, scene, 0, 2);
  ASSERT_EQ(before.size(), 2U);
  TrafficScene moved = scene;
  for (RoadUser& user : moved.users) user.start.y() += 1.1;
  const auto after = traffic.radar(moved.at(2.05));
  ASSERT_EQ(after.size(), 2U);
  for (const TrackedObject& object : after) {
    const auto same = std::ranges::find(before, object.id, &TrackedObject::id);
    ASSERT_NE(same, before.end());
    EXPECT_GT(object.y, same->y - 0.1) << "each followed to the left";
  }
}

TEST(ObjectTracker, NeverBelievesASingleFalseDetection) {
  TrackedTraffic traffic;
  const TrafficScene empty{{30, 0}, {}};
  for (int i = 0; i < 100; ++i) {
    const TrueFrame frame = empty.at(i * kLook);
    RadarScan scan = traffic.detected.scan(testing::kFrontRadar, frame);
    if (i % 5 == 0) scan.detections.push_back({20.0 + 7 * (i % 11), 0.02 * (i % 7) - 0.06, -2.0 + i % 3});
    traffic.add(scan, frame);
    EXPECT_TRUE(traffic.objects(frame).empty()) << i;
  }
}

TEST(ObjectTracker, NeedsSeveralLooksForATrack) {
  const TrafficScene scene{{30, 0}, {{{40, 0}, {30, 0}}}};
  TrackedTraffic traffic;
  EXPECT_TRUE(radar_only(traffic, scene, 0, 3 * kLook).empty());
  EXPECT_EQ(radar_only(traffic, scene, 3 * kLook, 1).size(), 1U);
}

TEST(ObjectTracker, KnowsAVehicleAgainThatWasHiddenForTwoSeconds) {
  const TrafficScene scene{{30, 0}, {{{25, 0}, {30, 0}}, {{45, 0.1}, {30, 0}}}};
  TrackedTraffic traffic;
  const auto before = fused(traffic, scene, 0, 2);
  ASSERT_EQ(before.size(), 2U);
  TrafficScene hidden = scene;
  hidden.users.pop_back();
  fused(traffic, hidden, 2, 4);
  const auto after = fused(traffic, scene, 4, 4.5);
  EXPECT_EQ(ids_of(after), ids_of(before));
}

TEST(ObjectTracker, ForgetsWithinASecondWhatVanishesInView) {
  const TrafficScene scene{{30, 0}, {{{45, 0}, {30, 0}}}};
  TrackedTraffic traffic;
  ASSERT_EQ(fused(traffic, scene, 0, 2).size(), 1U);
  EXPECT_TRUE(fused(traffic, {{30, 0}, {}}, 2, 3).empty());
}

TEST(ObjectTracker, RefusesTheMirrorImageInAGuardRail) {
  const TrafficScene scene{{30, 0}, {{{25, 1.75}, {30, 0}}, {{25, -12}, {30, 0}}}};
  TrackedTraffic traffic;
  const auto objects = radar_only(traffic, scene, 0, 3);
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_GT(objects[0].y, 0);
}

TEST(ObjectTracker, KeepsSilentOnWhatStands) {
  TrafficScene scene{{30, 0}, {}};
  for (int i = 0; i < 12; ++i) scene.users.push_back({{20.0 * i, i % 2 == 0 ? 6.0 : -6.0}, {0, 0}});
  TrackedTraffic traffic(1);
  for (const double t : moments(0, 5)) EXPECT_TRUE(traffic.radar(scene.at(t)).empty()) << t;
}

TEST(ObjectTracker, ReportsWhatComesTowardsUsAndNeverAsAWitness) {
  const TrafficScene scene{{30, 0}, {{{220, 9}, {-30, 0}}}};
  TrackedTraffic traffic;
  bool seen = false;
  for (const double t : moments(0, 3)) {
    for (const TrackedObject& object : traffic.both(scene.at(t))) {
      seen = true;
      EXPECT_NEAR(std::abs(object.heading), std::numbers::pi, 0.1);
      EXPECT_FALSE(is_witness(object, {}));
    }
  }
  EXPECT_TRUE(seen);
}

TEST(ObjectTracker, TakesSeveralReflectionsForOneVehicle) {
  const TrafficScene scene{{30, 0}, {{{40, 0}, {30, 0}}}};
  TrackedTraffic traffic(1);
  std::set<std::int64_t> ids;
  for (int i = 0; i < 80; ++i) {
    const TrueFrame frame = scene.at(i * kLook);
    RadarScan scan = traffic.detected.scan(testing::kFrontRadar, frame);
    for (const double across : {-0.6, 0.5}) {
      RadarDetection part = traffic.detected.scan(testing::kFrontRadar, frame).detections[0];
      part.bearing += across / part.range;
      part.range += 0.5 + across;
      scan.detections.push_back(part);
    }
    traffic.add(scan, frame);
    const auto objects = traffic.objects(frame);
    EXPECT_LE(objects.size(), 1U) << i;
    ids.merge(ids_of(objects));
  }
  EXPECT_EQ(ids.size(), 1U);
}

/// Three vehicles, of which the first moves a lane to the right from second 3 on, a metre a second.
TrueFrame lane_change(double seconds) {
  const TrafficScene scene{{30, 0}, {{{35, 3.5}, {30, 0}}, {{60, 0}, {30, 0}}, {{45, -3.5}, {30, 0}}}};
  TrueFrame frame = scene.at(seconds);
  const double done = std::clamp((seconds - 3) / 3.5, 0.0, 1.0);
  Pose2& pose = frame.objects[0].world_from_object;
  pose.y -= 3.5 * done;
  if (done > 0 && done < 1) pose.heading = std::atan2(-1, 30);
  return frame;
}

TEST(ObjectTracker, MarksALaneChangeSoonAndUnmarksItAfterwards) {
  TrackedTraffic traffic;
  double begin = 0;
  double end = 0;
  for (const double t : moments(0, 10)) {
    const TrueFrame frame = lane_change(t);
    const auto objects = traffic.both(frame);
    const TrackedObject* object = nearest(objects, frame, frame.objects[0]);
    if (t < 1) continue;
    ASSERT_NE(object, nullptr) << t;
    if (object->changing_lane && begin == 0) begin = t;
    if (object->changing_lane) end = t;
  }
  EXPECT_GT(begin, 3);
  EXPECT_LT(begin, 4.5) << "a vehicle that moves a metre a second across is sure to in a second and a half";
  EXPECT_GT(end, 6);
  EXPECT_LT(end, 8.5);
}

TEST(ObjectTracker, StatesAnUncertaintyThatFitsItsErrors) {
  const TrafficScene scene{{30, 0.01}, {{{40, 1}, {31, 0.5}}, {{70, -2}, {29, 0.7}}}};
  TrackedTraffic traffic(1);
  double squares = 0;
  int count = 0;
  for (const double t : moments(0, 15)) {
    const TrueFrame frame = scene.at(t);
    const auto objects = traffic.both(frame);
    for (const TrueObject& vehicle : frame.objects) {
      const TrackedObject* object = nearest(objects, frame, vehicle);
      if (t < 1 || !object) continue;
      const Eigen::Vector2d truth = frame.world_from_vehicle.inverse() * vehicle.world_from_object.position();
      const Eigen::Vector2d off = Eigen::Vector2d(object->x, object->y) - truth;
      squares += off.dot(object->covariance.topLeftCorner<2, 2>().inverse() * off);
      ++count;
    }
  }
  ASSERT_GT(count, 400);
  EXPECT_LT(squares / count, 3) << "two degrees of freedom: not overconfident";
  EXPECT_GT(squares / count, 0.1) << "nor useless";
}

}  // namespace
}  // namespace lanefuse
