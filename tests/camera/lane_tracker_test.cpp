// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_tracker.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "painted_road.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLinePitch = 3.65;           // [m] between the middles of markings
constexpr double kInner = kLinePitch - 0.15;  // [m] between their inner edges
constexpr double kSpeed = 30;                 // [m/s]
constexpr Duration kFrame = from_seconds(0.04);

/// A car on a road that is painted as it goes.
class Drive {
 public:
  Clothoid lane{0.2, 0.005, 4e-4, 0};  ///< the ego lane's middle
  CameraPose assumed;
  CameraPose truth;
  int to_left = 1;
  int to_right = 1;
  double noise = 2;
  bool blind = false;
  double turn = 0;  ///< [rad/s] on top of the road's
  std::vector<VehicleBox> vehicles;
  std::vector<PaintedLine> more;

  Drive() { assumed.mounting = truth.mounting = usual_mounting(); }

  const LaneTrack& step(LaneTracker& tracker, int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      way_ += kSpeed * to_seconds(kFrame);
      std::vector<PaintedLine> lines = painted_lanes(lane, kLinePitch, to_left, to_right);
      for (PaintedLine& line : lines) line.phase = -way_;
      lines.insert(lines.end(), more.begin(), more.end());
      if (blind) lines.clear();
      const Image& image = painter_.paint(truth, lines, noise);
      time_ += kFrame;
      tracker.track({image.view(), time_, assumed, kSpeed, kSpeed * lane.curvature + turn, vehicles});
    }
    return tracker.last();
  }

 private:
  RoadPainter painter_{serial_camera()};
  Time time_ = from_nanoseconds(1'000'000'000);
  double way_ = 0;
};

void expect_lane(const LaneTrack& track, const Clothoid& middle, double tolerance) {
  ASSERT_TRUE(track.left && track.right);
  for (const double x : {8.0, 20.0, 40.0, 60.0}) {
    const double grown = tolerance * (1 + x / 30);
    EXPECT_NEAR(track.left->clothoid.y(x), middle.y(x) + kInner / 2, grown) << "at " << x;
    EXPECT_NEAR(track.right->clothoid.y(x), middle.y(x) - kInner / 2, grown) << "at " << x;
  }
}

TEST(LaneTracker, FindsTheLaneWhereItIs) {
  Drive drive;
  LaneTracker tracker(serial_camera());
  EXPECT_NE(drive.step(tracker).status, LaneTrackStatus::lost);
  const LaneTrack& track = drive.step(tracker, 9);
  EXPECT_EQ(track.status, LaneTrackStatus::tracking);
  expect_lane(track, drive.lane, 0.03);
  EXPECT_NEAR(track.width, kInner, 0.03);
  EXPECT_NEAR(track.pitch, 0, 0.05 * kDegree);
  EXPECT_GT(track.range, 60);
  EXPECT_NEAR(track.left_marking_width.value_or(0), 0.15, 0.02);
  EXPECT_EQ(track.left->side, Side::left);
  EXPECT_FALSE(track.windows.empty());
}

TEST(LaneTracker, TellsSolidFromDashedAndColours) {
  Drive drive;
  drive.to_left = 0;
  LaneTracker tracker(serial_camera());
  const LaneTrack& track = drive.step(tracker, 30);
  ASSERT_TRUE(track.left && track.right);
  EXPECT_EQ(track.left->marking.type, MarkingType::solid);
  EXPECT_EQ(track.right->marking.type, MarkingType::dashed);
  EXPECT_EQ(track.left->marking.colour, MarkingColour::white);
}

TEST(LaneTracker, MeasuresThePitchOfEveryImage) {
  Drive drive;
  LaneTracker tracker(serial_camera());
  drive.step(tracker, 10);
  for (const double pitch : {0.6, -0.2, 0.4, -0.5}) {
    drive.truth.mounting.pitch = drive.assumed.mounting.pitch + pitch * kDegree;
    const LaneTrack& track = drive.step(tracker);
    EXPECT_EQ(track.status, LaneTrackStatus::tracking);
    EXPECT_NEAR(track.pitch / kDegree, pitch, 0.08);
    expect_lane(track, drive.lane, 0.06);
  }
}

TEST(LaneTracker, SeesTheRoadBendDownBehindACrest) {
  Drive drive;
  drive.truth.vertical_curvature = -8e-5;
  LaneTracker tracker(serial_camera());
  const LaneTrack& track = drive.step(tracker, 12);
  ASSERT_EQ(track.status, LaneTrackStatus::tracking);
  EXPECT_LT(track.vertical_curvature, -3e-5);
  expect_lane(track, drive.lane, 0.06);
}

TEST(LaneTracker, FollowsTheCarIntoTheNextLane) {
  Drive drive;
  LaneTracker tracker(serial_camera());
  drive.step(tracker, 10);
  // In 4 s one lane to the left: the lane moves to the right.
  const Clothoid before = drive.lane;
  constexpr int kImages = 100;
  int changes = 0;
  for (int i = 1; i <= kImages; ++i) {
    const double phase = std::numbers::pi * i / kImages;
    const double rate = std::numbers::pi / (kImages * to_seconds(kFrame));  // [1/s]
    drive.lane.lateral_offset = before.lateral_offset - kLinePitch * (1 - std::cos(phase)) / 2;
    drive.lane.heading = -kLinePitch * std::sin(phase) / 2 * rate / kSpeed;
    drive.turn = kLinePitch * std::cos(phase) / 2 * rate * rate / kSpeed;
    const LaneTrack& track = drive.step(tracker);
    ASSERT_EQ(track.status, LaneTrackStatus::tracking) << "in image " << i;
    changes += track.lane_changed ? 1 : 0;
  }
  EXPECT_EQ(changes, 1);
  Clothoid next = drive.lane;
  next.lateral_offset += kLinePitch;
  expect_lane(tracker.last(), next, 0.05);
}

TEST(LaneTracker, LosesTheLaneInTheDarkAndFindsItAgain) {
  Drive drive;
  LaneTracker tracker(serial_camera());
  drive.step(tracker, 10);
  drive.blind = true;
  EXPECT_EQ(drive.step(tracker, 30).status, LaneTrackStatus::lost);
  EXPECT_FALSE(tracker.last().left);
  drive.blind = false;
  drive.lane.lateral_offset = -0.5;
  const LaneTrack& track = drive.step(tracker, 8);
  EXPECT_EQ(track.status, LaneTrackStatus::tracking);
  expect_lane(track, drive.lane, 0.05);
}

TEST(LaneTracker, FindsTheLaneAgainWhenTheCameraIsKnocked) {
  Drive drive;
  LaneTracker tracker(serial_camera());
  drive.step(tracker, 10);
  drive.truth.mounting.yaw += 1.2 * kDegree;
  drive.truth.mounting.pitch += 1 * kDegree;
  const LaneTrack& track = drive.step(tracker, 25);
  ASSERT_EQ(track.status, LaneTrackStatus::tracking);
  EXPECT_NEAR(track.pitch / kDegree, 1, 0.1);
  EXPECT_NEAR(track.width, kInner, 0.05);
}

TEST(LaneTracker, HandsNothingOverWhereThereIsNoLane) {
  Drive drive;
  drive.blind = true;
  LaneTracker tracker(serial_camera());
  for (int i = 0; i < 10; ++i) EXPECT_NE(drive.step(tracker).status, LaneTrackStatus::tracking);
}

TEST(LaneTracker, IsNotLuredByAStripeInsideTheLane) {
  Drive drive;
  PaintedLine stripe;  // a seam, half as bright as paint
  stripe.middle = drive.lane;
  stripe.middle.lateral_offset += 0.6;
  stripe.colour = {150, 150, 150};
  drive.more = {stripe};
  LaneTracker tracker(serial_camera());
  expect_lane(drive.step(tracker, 12), drive.lane, 0.05);
}

TEST(LaneTracker, LooksPastVehicles) {
  Drive drive;
  drive.vehicles.push_back({300, 300, 560, 420, 20, 1, 1.8, 1});
  LaneTracker tracker(serial_camera());
  const LaneTrack& track = drive.step(tracker, 10);
  for (const SearchWindow& window : track.windows) {
    if (window.row < 300 || window.row > 420) continue;
    EXPECT_FALSE(window.found && window.column > 300 && window.column < 560);
  }
}

TEST(LaneTracker, ALearnedPoseDoesNotDisturb) {
  Drive drive;
  drive.truth.mounting.pitch += 0.5 * kDegree;
  drive.truth.mounting.yaw += 0.5 * kDegree;
  LaneTracker tracker(serial_camera());
  drive.step(tracker, 10);
  drive.assumed = drive.truth;
  const LaneTrack& track = drive.step(tracker);
  EXPECT_NEAR(track.pitch, 0, 0.1 * kDegree);
  expect_lane(track, drive.lane, 0.06);
}

TEST(LaneTracker, SaysHowUncertainItIs) {
  Drive drive;
  LaneTracker tracker(serial_camera());
  drive.assumed.covariance.diagonal() << 1e-4, 1e-6, 1e-6, 4e-6;
  const LaneTrack& track = drive.step(tracker, 10);
  ASSERT_TRUE(track.left);
  EXPECT_GE(track.left->covariance(1, 1), 4e-6) << "the pose's yaw is not counted in";
  const Eigen::LLT<Eigen::Matrix4d> llt(track.left->covariance);
  EXPECT_EQ(llt.info(), Eigen::Success);
}

TEST(LaneTracker, SameImagesSameTrack) {
  Drive one;
  Drive other;
  LaneTracker first(serial_camera());
  LaneTracker second(serial_camera());
  for (int i = 0; i < 6; ++i) {
    const LaneTrack& a = one.step(first);
    const LaneTrack& b = other.step(second);
    EXPECT_EQ(a.lateral_offset, b.lateral_offset);
    EXPECT_EQ(a.pitch, b.pitch);
    EXPECT_EQ(a.windows.size(), b.windows.size());
  }
}

TEST(LaneTracker, SeesHowWideTheNextLanesAre) {
  Drive drive;
  LaneTracker tracker(serial_camera());
  double left = 0;
  double right = 0;
  int left_seen = 0;
  int right_seen = 0;
  for (int i = 0; i < 20; ++i) {
    const LaneTrack& track = drive.step(tracker);
    if (track.left_neighbour) left += track.left_neighbour->width, ++left_seen;
    if (track.right_neighbour) right += track.right_neighbour->width, ++right_seen;
  }
  ASSERT_GT(left_seen, 5);
  ASSERT_GT(right_seen, 5);
  EXPECT_NEAR(left / left_seen, kInner, 0.06);
  EXPECT_NEAR(right / right_seen, kInner, 0.06);
}

}  // namespace
}  // namespace lanefuse
