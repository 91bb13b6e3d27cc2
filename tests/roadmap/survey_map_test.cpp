// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "roadmap/map_comparison.hpp"
#include "roadmap/map_localiser.hpp"
#include "survey_road.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;
using testing::kLaneWidth;
using testing::kOrigin;
using testing::SurveyDriver;
using ::testing::ThrowsMessage;

SurveyedDrive surveyed(const std::vector<Measurement>& measurements) {
  SurveyRecorder recorder("drive.mcap", GeoFrame(kOrigin), testing::survey_rig());
  for (const Measurement& measurement : measurements) recorder.add(measurement);
  return recorder.finish();
}

std::vector<SurveyedDrive> both_lanes(const Pose2& world, double camera_yaw = 0) {
  return {surveyed(SurveyDriver{world, 0, 20, camera_yaw}.drive()),
          surveyed(SurveyDriver{world, 1, 20, camera_yaw}.drive())};
}

RoadMap true_map(const Pose2& world) {
  RoadMap map{"truth", kOrigin, {}, {}};
  for (int i = 0; i < 3; ++i) {
    MapBoundary boundary{static_cast<std::uint64_t>(i) + 1, {}, {{}}};
    for (double station = -20; station <= 640; station += 1) {
      const Pose2 pose = testing::on_road(world, station, (1 - i) * kLaneWidth);
      boundary.points.emplace_back(pose.x, pose.y, 0);
    }
    map.boundaries.push_back(boundary);
  }
  return map;
}

void expect_exact(const RoadMap& map, const Pose2& world, double tolerance) {
  const MapComparison comparison = compare(map, true_map(world));
  ASSERT_EQ(map.boundaries.size(), 3u);
  EXPECT_LT(comparison.all.max, tolerance);
  EXPECT_EQ(comparison.strays, 0u);
  for (const BoundaryComparison& boundary : comparison.boundaries) EXPECT_GT(boundary.covered, 580);
}

TEST(SurveyMap, NoiselessDrivesGiveTheExactMap) {
  const RoadMap map = survey_map(both_lanes({}), kOrigin);
  expect_exact(map, {}, 0.005);
  ASSERT_EQ(map.lanes.size(), 2u);
  EXPECT_EQ(map.lanes[0].right_lane, map.lanes[1].id);
  EXPECT_EQ(map.lanes[1].left_lane, map.lanes[0].id);
  EXPECT_EQ(map.boundaries[0].styles.front().marking.type, MarkingType::solid);
  EXPECT_EQ(map.boundaries[1].styles.front().marking.type, MarkingType::dashed);
  EXPECT_NEAR(map.boundaries[1].styles.front().width, testing::kLanePaint, 0.011);
}

TEST(SurveyMap, CameraThatLooksAsideChangesLittle) {
  expect_exact(survey_map(both_lanes({}, 0.004), kOrigin), {}, 0.01);
}

RC_GTEST_PROP(SurveyMap, WhereTheRoadLiesDoesNotMatter, ()) {
  const auto metres = [] { return static_cast<double>(*rc::gen::inRange(-5000, 5000)); };
  const Pose2 world{metres(), metres(), *rc::gen::inRange(-314, 314) / 100.0};
  expect_exact(survey_map(both_lanes(world), kOrigin), world, 0.01);
}

TEST(SurveyMap, OneLaneAloneIsAMapToo) {
  const RoadMap map = survey_map(std::vector{surveyed(SurveyDriver{}.drive())}, kOrigin);
  EXPECT_EQ(map.boundaries.size(), 2u);
  EXPECT_EQ(map.lanes.size(), 1u);
}

TEST(SurveyMap, DriveWithoutFixesIsRefused) {
  std::vector<Measurement> measurements = SurveyDriver{}.drive();
  std::erase_if(measurements, [](const auto& m) { return std::holds_alternative<GnssInsFix>(m); });
  EXPECT_THAT([&] { surveyed(measurements); },
              ThrowsMessage<Error>(HasSubstr("drive.mcap: holds no GNSS/INS")));
}

TEST(SurveyMap, DriveWithoutMarkingsIsRefused) {
  std::vector<Measurement> measurements = SurveyDriver{}.drive();
  std::erase_if(measurements, [](const auto& m) { return std::holds_alternative<SerialLane>(m); });
  EXPECT_THAT([&] { surveyed(measurements); },
              ThrowsMessage<Error>(HasSubstr("drive.mcap: holds no marking")));
}

TEST(SurveyMap, DriveInWhichTheClockWasSetIsRefused) {
  std::vector<Measurement> measurements = SurveyDriver{}.drive();
  for (Measurement& measurement : measurements) {
    std::visit(
        [](auto& m) {
          if (m.stamp.measured_at <= from_nanoseconds(8'000'000'000)) return;
          m.stamp.measured_at += from_seconds(1.7e9);
          m.stamp.received_at += from_seconds(1.7e9);
        },
        measurement);
  }
  EXPECT_THAT([&] { surveyed(measurements); },
              ThrowsMessage<Error>(HasSubstr("drive.mcap: has no GNSS/INS fix for 17000000")));
}

TEST(SurveyMap, HoleInTheFixesIsBridgedByOdometry) {
  std::vector<Measurement> measurements = SurveyDriver{}.drive();
  std::erase_if(measurements, [](const auto& m) {
    const auto* fix = std::get_if<GnssInsFix>(&m);
    return fix && fix->stamp.measured_at > from_nanoseconds(8'000'000'000) &&
           fix->stamp.measured_at < from_nanoseconds(13'000'000'000);
  });
  const RoadMap map = survey_map(std::vector{surveyed(measurements)}, kOrigin);
  EXPECT_LT(compare(map, true_map({})).all.max, 0.05);
}

TEST(MapLocaliser, FindsTheLaneAndTakesOffAFixedError) {
  const RoadMap map = survey_map(both_lanes({}), kOrigin);
  SurveyedDrive drive = surveyed(SurveyDriver{{}, 1}.drive());
  const std::vector<TrackNode> exact = drive.track;
  for (TrackNode& node : drive.track) node.map_from_vehicle = node.map_from_vehicle * Pose2{0, 0.05, 0};
  std::vector<Time> times;
  for (const TrackNode& node : drive.track) times.push_back(node.time);
  const std::vector<MapPose> poses = localise(drive, map, times);
  ASSERT_EQ(poses.size(), times.size());
  const MapPose& last = poses[poses.size() - 20];
  EXPECT_EQ(last.lane_number, 2);
  const Pose2 off = pose_at(exact, last.time)->inverse() * last.by_map;
  EXPECT_LT(std::abs(off.y), 0.02);
}

}  // namespace
}  // namespace lanefuse
