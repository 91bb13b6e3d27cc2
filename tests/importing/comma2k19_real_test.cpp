// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>

#include "importing/comma2k19.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

/// The real minute of comma2k19: facts about it that hold the reading of its columns and signs.
class Comma2k19RealMinute : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto folder = testing::real_data("comma2k19");
    LANEFUSE_NEEDS_DATA(folder)
    drive_ = import_comma2k19(folder);
  }

  template <typename Kind>
  [[nodiscard]] std::vector<Kind> all_of() const {
    std::vector<Kind> found;
    for (const Measurement& measurement : drive_.measurements) {
      if (const auto* one = std::get_if<Kind>(&measurement)) found.push_back(*one);
    }
    return found;
  }

  [[nodiscard]] const TrueFrame& frame_at(Time time) const {
    const auto after = std::lower_bound(drive_.truth.begin(), drive_.truth.end(), time,
                                        [](const TrueFrame& frame, Time t) { return frame.time < t; });
    return after == drive_.truth.end() ? drive_.truth.back() : *after;
  }

  ImportedDrive drive_;
};

TEST_F(Comma2k19RealMinute, IsReadWhole) {
  EXPECT_EQ(drive_.info.name, "comma2k19 b0c9d2329ad1606b_2018-08-02--08-34-47/40");
  const auto scans = all_of<RadarScan>();
  EXPECT_EQ(scans.size(), 1200U);
  EXPECT_EQ(
      std::accumulate(scans.begin(), scans.end(), std::size_t{0},
                      [](std::size_t sum, const RadarScan& scan) { return sum + scan.detections.size(); }),
      10100U);
  EXPECT_EQ(all_of<VehicleMotion>().size(), 4974U + 4974U + 6256U);
  EXPECT_EQ(drive_.truth.size(), 1200U);
  EXPECT_NEAR(to_seconds(drive_.truth.back().time - drive_.truth.front().time), 60, 0.1);
  for (const Measurement& measurement : drive_.measurements)
    EXPECT_EQ(implausible(measurement), std::nullopt);
}

TEST_F(Comma2k19RealMinute, BusSpeedIsOnePercentLow) {
  double sum = 0;
  double count = 0;
  for (const VehicleMotion& motion : all_of<VehicleMotion>()) {
    if (!motion.speed) continue;
    sum += frame_at(motion.stamp.measured_at).speed / *motion.speed;
    ++count;
  }
  EXPECT_NEAR(sum / count, 1.009, 0.002);
}

TEST_F(Comma2k19RealMinute, GyroAndPosesTurnTheSameWay) {
  double product = 0;
  double square = 0;
  for (const VehicleMotion& motion : all_of<VehicleMotion>()) {
    if (!motion.yaw_rate) continue;
    const double truth = frame_at(motion.stamp.measured_at).yaw_rate;
    product += *motion.yaw_rate * truth;
    square += truth * truth;
  }
  EXPECT_NEAR(product / square, 1, 0.1);
}

TEST_F(Comma2k19RealMinute, RoadIsStraight) {
  const Pose2 start = drive_.truth.front().world_from_vehicle;
  const Pose2 end = drive_.truth.back().world_from_vehicle;
  const Eigen::Vector2d chord = end.position() - start.position();
  EXPECT_NEAR(chord.norm(), 1011, 1);
  const Pose2 chord_from_world = Pose2{start.x, start.y, std::atan2(chord.y(), chord.x())}.inverse();
  for (const TrueFrame& frame : drive_.truth) {
    const Pose2 pose = chord_from_world * frame.world_from_vehicle;
    EXPECT_LT(std::abs(pose.y), 0.5);
    EXPECT_LT(std::abs(pose.heading), 0.03);
  }
}

/// What stands still keeps its place in the world while the car passes it, if range, bearing, signs and
/// mounting are read well; mirrored bearings smear it by metres.
TEST_F(Comma2k19RealMinute, StandingThingsStandStill) {
  const Pose2 vehicle_from_radar{drive_.rig.find(kCommaRadar)->mounting.x, 0, 0};
  std::vector<double> bearings_off;
  std::vector<Eigen::Vector2d> last_seen(1024, Eigen::Vector2d::Constant(1e9));
  std::vector<double> steps;
  for (const RadarScan& scan : all_of<RadarScan>()) {
    const TrueFrame& frame = frame_at(scan.stamp.measured_at);
    for (const RadarDetection& point : scan.detections) {
      auto& last = last_seen[static_cast<std::size_t>(*point.address)];
      const bool stands = std::abs(point.range_rate + frame.speed * std::cos(point.bearing)) < 0.5;
      const Eigen::Vector2d in_radar =
          point.range * Eigen::Vector2d(std::cos(point.bearing), std::sin(point.bearing));
      const Eigen::Vector2d in_world = frame.world_from_vehicle * vehicle_from_radar * in_radar;
      if (stands && !point.new_track && (in_world - last).norm() < 5)
        steps.push_back((in_world - last).norm());
      last = stands ? in_world : Eigen::Vector2d::Constant(1e9);
    }
  }
  ASSERT_GT(steps.size(), 1000U);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  EXPECT_LT(steps[steps.size() / 2], 0.15);
}

}  // namespace
}  // namespace lanefuse
