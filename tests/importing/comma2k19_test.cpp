// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "importing/comma2k19.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "importing/comma2k19_truth.hpp"
#include "importing/synthetic_segment.hpp"

namespace lanefuse {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using testing::SyntheticSegment;
using ::testing::ThrowsMessage;

class Comma2k19Test : public ::testing::Test {
 protected:
  Comma2k19Test()
      : root_(std::filesystem::path(::testing::TempDir()) /
              (std::string("lanefuse_comma_") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
    root_ = std::filesystem::canonical(root_);
  }
  ~Comma2k19Test() override { std::filesystem::remove_all(root_); }

  SyntheticSegment write(const std::string& name = "route/7") { return SyntheticSegment(root_ / name); }

  std::filesystem::path root_;
};

template <typename Kind>
std::vector<Kind> all_of(const ImportedDrive& drive) {
  std::vector<Kind> found;
  for (const Measurement& measurement : drive.measurements) {
    if (const auto* one = std::get_if<Kind>(&measurement)) found.push_back(*one);
  }
  return found;
}

TEST_F(Comma2k19Test, TakesTheSegmentOrAFolderThatHoldsIt) {
  const SyntheticSegment segment = write();
  for (const auto& where : {segment.directory, segment.directory.parent_path(), root_}) {
    EXPECT_EQ(import_comma2k19(where).info.name, "comma2k19 route/7") << where;
  }
}

TEST_F(Comma2k19Test, AsksWhichOfTwoSegments) {
  write("route/7");
  write("route/8");
  EXPECT_THAT([&] { import_comma2k19(root_); },
              ThrowsMessage<Error>(AllOf(HasSubstr("2 comma2k19 segments"), HasSubstr("route/7, route/8"))));
}

TEST_F(Comma2k19Test, SaysWhatItExpected) {
  EXPECT_THAT(
      [&] { import_comma2k19(root_); },
      ThrowsMessage<Error>(AllOf(HasSubstr(root_.string()), HasSubstr("processed_log and global_pose"))));
  EXPECT_THAT([&] { import_comma2k19(root_ / "nowhere"); }, ThrowsMessage<Error>(HasSubstr("nowhere")));
}

TEST_F(Comma2k19Test, SetsTheWitnessRuleOpenly) {
  const ImportedDrive drive = import_comma2k19(write().directory);
  EXPECT_EQ(drive.info.witness, WitnessRule::radar_only);
  EXPECT_THAT(drive.notes, Contains(HasSubstr("radar_only")));
  EXPECT_FALSE(drive.rig.has_camera());
}

TEST_F(Comma2k19Test, MakesRadarPolarAndPositiveToTheLeft) {
  const auto scans = all_of<RadarScan>(import_comma2k19(write().directory));
  ASSERT_EQ(scans.size(), SyntheticSegment::kScans);
  ASSERT_EQ(scans[0].detections.size(), 2U);
  const RadarDetection& left = scans[0].detections[0];
  EXPECT_DOUBLE_EQ(left.range, std::hypot(40, 3));
  EXPECT_DOUBLE_EQ(left.bearing, std::atan2(3, 40));
  EXPECT_EQ(left.range_rate, -2);
  EXPECT_EQ(left.address, 528);
  EXPECT_TRUE(left.new_track);
  EXPECT_LT(scans[0].detections[1].bearing, 0);
  EXPECT_FALSE(scans[1].detections[0].new_track);
}

TEST_F(Comma2k19Test, AScanIsReceivedWithItsLastPoint) {
  const RadarScan scan = all_of<RadarScan>(import_comma2k19(write().directory)).front();
  EXPECT_EQ(scan.stamp.measured_at, from_nanoseconds(1'000'000'000'000));
  EXPECT_NEAR(to_seconds(scan.stamp.received_at - scan.stamp.measured_at), 0.004, 1e-9);
}

TEST_F(Comma2k19Test, MotionCarriesSpeedWheelsAndTurnsToTheLeft) {
  std::size_t speeds = 0;
  std::size_t wheels = 0;
  std::size_t turns = 0;
  for (const VehicleMotion& motion : all_of<VehicleMotion>(import_comma2k19(write().directory))) {
    if (motion.speed) speeds += *motion.speed == SyntheticSegment::kSpeed;
    if (motion.wheel_speeds) wheels += *motion.wheel_speeds == std::array<double, 4>{19, 20, 21, 22};
    if (motion.yaw_rate) turns += *motion.yaw_rate == -SyntheticSegment::kTurnRight;
  }
  EXPECT_EQ(speeds, SyntheticSegment::kScans);
  EXPECT_EQ(wheels, SyntheticSegment::kScans);
  EXPECT_EQ(turns, SyntheticSegment::kScans);
}

TEST_F(Comma2k19Test, MeasurementsComeInOrderOfReception) {
  const ImportedDrive drive = import_comma2k19(write().directory);
  EXPECT_TRUE(std::is_sorted(
      drive.measurements.begin(), drive.measurements.end(),
      [](const auto& a, const auto& b) { return stamp_of(a).received_at < stamp_of(b).received_at; }));
}

TEST_F(Comma2k19Test, TruthIsTheFrontAxleOnItsWayNorth) {
  const ImportedDrive drive = import_comma2k19(write().directory);
  ASSERT_EQ(drive.truth.size(), SyntheticSegment::kScans);
  const TrueFrame& last = drive.truth.back();
  EXPECT_NEAR(last.world_from_vehicle.x, 0, 1e-6);
  EXPECT_NEAR(last.world_from_vehicle.y, 39 + kCommaCameraBehindFrontAxle, 1e-6);
  EXPECT_NEAR(last.world_from_vehicle.heading, std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(last.speed, 20, 1e-9);
  EXPECT_NEAR(last.yaw_rate, 0, 1e-9);
}

TEST_F(Comma2k19Test, NamesAMissingArray) {
  const SyntheticSegment segment = write();
  std::filesystem::remove(segment.directory / "processed_log/CAN/wheel_speed/value");
  EXPECT_THAT([&] { import_comma2k19(root_); }, ThrowsMessage<Error>(HasSubstr("wheel_speed/value")));
}

TEST_F(Comma2k19Test, NamesAnArrayThatIsCut) {
  const SyntheticSegment segment = write();
  std::filesystem::resize_file(segment.directory / "global_pose/frame_times", 200);
  EXPECT_THAT([&] { import_comma2k19(root_); }, ThrowsMessage<Error>(HasSubstr("global_pose/frame_times")));
}

TEST(Headings, LoseTheMountingYawButNoTurn) {
  std::vector<Time> times;
  std::vector<double> yaws;
  std::vector<double> courses;
  for (std::int64_t i = 0; i < 200; ++i) {
    times.push_back(from_nanoseconds(i * 50'000'000));
    courses.push_back(0.1 * std::sin(0.05 * static_cast<double>(i)));
    yaws.push_back(courses.back() + 0.3);
  }
  const auto headings = headings_without_mounting(times, yaws, courses, std::vector<double>(200, 20.0));
  for (std::size_t i = 0; i < 200; ++i) EXPECT_NEAR(headings[i], courses[i], 1e-12);
}

TEST(Headings, CoursesOfAStandingCarDoNotCount) {
  std::vector<Time> times;
  std::vector<double> speeds;
  std::vector<double> courses;
  for (std::int64_t i = 0; i < 400; ++i) {
    times.push_back(from_nanoseconds(i * 50'000'000));
    speeds.push_back(i < 200 ? 20 : 0);
    courses.push_back(i < 200 ? 1 : static_cast<double>(1 + i % 3));
  }
  const auto headings = headings_without_mounting(times, std::vector<double>(400, 1.2), courses, speeds);
  EXPECT_NEAR(headings.front(), 1, 1e-12);
  EXPECT_NEAR(headings.back(), 1, 1e-12);
}

}  // namespace
}  // namespace lanefuse
