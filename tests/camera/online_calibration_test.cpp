// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/online_calibration.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFrame = 0.04;   // [s]
constexpr double kSpeed = 30;     // [m/s]
constexpr double kWidth = 3.5;    // [m]
constexpr double kPaint = 0.15;   // [m]
constexpr double kHeight = 1.25;  // [m]

/// A tracker that sees a straight road through a camera that hangs otherwise than assumed: what it would hand
/// over, by the first-order geometry of a flat road, with a tracker's noise.
class Camera {
 public:
  Mounting truth{0, 0, kHeight, 0, 0.01, 0};
  double speed = kSpeed;
  bool neighbours = true;
  double swing = 1;  ///< times the usual motion of the body

  explicit Camera(std::uint64_t seed)
      : random_(seed, "camera"), pitch_(0.0044, 0.3, random_), roll_(0.0026, 0.5, random_) {}

  void drive(OnlineCalibration& calibration, double seconds) {
    for (double t = 0; t < seconds - 1e-9; t += kFrame) step(calibration);
  }

  void step(OnlineCalibration& calibration) {
    now_ += from_seconds(kFrame);
    phase_ += kFrame;
    pitch_.advance(kFrame, random_);
    roll_.advance(kFrame, random_);
    // The car wanders in its lane.
    const double offset = 0.3 * std::sin(0.5 * phase_);
    const double heading = 0.15 * std::cos(0.5 * phase_) / kSpeed;
    const CameraPose& pose = calibration.pose();
    const double rolled = truth.roll + swing * roll_.value() - pose.mounting.roll;
    const auto seen = [&](double y) {
      return (y - rolled * (kHeight + y * y / kHeight)) * pose.mounting.z / truth.z;
    };
    LaneTrack track;
    track.measured_at = now_;
    track.status = LaneTrackStatus::tracking;
    track.left.emplace();
    track.right.emplace();
    const double left = seen(offset + kWidth / 2);
    const double right = seen(offset - kWidth / 2);
    track.width = left - right;
    track.width_sigma = 0.02;
    track.lateral_offset = (left + right) / 2 + random_.normal(0.01);
    track.heading = heading - (truth.yaw - pose.mounting.yaw) + random_.normal(0.0005);
    track.pitch = truth.pitch + swing * pitch_.value() - pose.mounting.pitch + random_.normal(0.0003);
    if (neighbours) {
      const double width = seen(offset - kWidth / 2 - kPaint) - seen(offset - 1.5 * kWidth - kPaint);
      track.right_neighbour = {width + random_.normal(0.03), 0.03};
    }
    calibration.update(track, speed, 0, now_);
  }

 private:
  Random random_;
  Wander pitch_;
  Wander roll_;
  Time now_ = from_nanoseconds(1'000'000'000);
  double phase_ = 0;
};

Mounting nominal() { return {0, 0, kHeight, 0, 0.01, 0}; }

TEST(OnlineCalibration, StartsFromTheMounting) {
  const OnlineCalibration calibration(nominal());
  EXPECT_EQ(calibration.pose().mounting, nominal());
  EXPECT_EQ(calibration.status(), CalibrationStatus::learning);
  EXPECT_GT(calibration.pose().covariance(2, 2), 1e-5);
}

TEST(OnlineCalibration, LearnsPitchAndYaw) {
  Camera camera(1);
  camera.truth.pitch += 0.5 * kDegree;
  camera.truth.yaw -= 0.4 * kDegree;
  OnlineCalibration calibration(nominal());
  camera.drive(calibration, 30);
  EXPECT_EQ(calibration.status(), CalibrationStatus::steady);
  EXPECT_NEAR(calibration.pose().mounting.pitch, camera.truth.pitch, 0.1 * kDegree);
  EXPECT_NEAR(calibration.pose().mounting.yaw, camera.truth.yaw, 0.1 * kDegree);
  EXPECT_NEAR(calibration.pose().mounting.z, kHeight, 1e-6) << "nothing tells the height";
}

TEST(OnlineCalibration, LearnsRollFromTheNeighbourLane) {
  Camera camera(2);
  camera.truth.roll = 0.7 * kDegree;
  OnlineCalibrationConfig config;
  config.roll_sigma = 0.02;
  config.lane_difference_sigma = 0.03;
  OnlineCalibration calibration(nominal(), config);
  camera.drive(calibration, 30);
  EXPECT_NEAR(calibration.pose().mounting.roll, camera.truth.roll, 0.15 * kDegree);
}

TEST(OnlineCalibration, LearnsTheHeightFromAKnownLaneWidthOnly) {
  Camera camera(3);
  camera.truth.z = 1.30;
  OnlineCalibrationConfig config;
  config.height_sigma = 0.1;
  config.lane_width = kWidth;
  config.lane_width_sigma = 0.02;
  OnlineCalibration calibration(nominal(), config);
  camera.drive(calibration, 60);
  EXPECT_NEAR(calibration.pose().mounting.z, 1.30, 0.02);
}

TEST(OnlineCalibration, IsAsGoodAsItSays) {
  // Squared errors over variances, of pitch and yaw: about one on average, in different drives.
  double pitch = 0;
  double yaw = 0;
  constexpr int kDrives = 30;
  for (int i = 0; i < kDrives; ++i) {
    Camera camera(100 + static_cast<std::uint64_t>(i));
    Random random(static_cast<std::uint64_t>(i), "mounting");
    camera.truth.pitch += random.normal(0.005);
    camera.truth.yaw += random.normal(0.0035);
    OnlineCalibration calibration(nominal());
    camera.drive(calibration, 20);
    const CameraPose& pose = calibration.pose();
    pitch += std::pow(pose.mounting.pitch - camera.truth.pitch, 2) / pose.covariance(2, 2) / kDrives;
    yaw += std::pow(pose.mounting.yaw - camera.truth.yaw, 2) / pose.covariance(3, 3) / kDrives;
  }
  EXPECT_LT(pitch, 2.5);
  EXPECT_LT(yaw, 2.5);
  EXPECT_GT(pitch, 0.2);
}

struct Knock {
  double roll;
  double pitch;
  double yaw;
};

void PrintTo(const Knock& knock, std::ostream* out) {
  *out << "roll " << knock.roll / kDegree << ", pitch " << knock.pitch / kDegree << ", yaw "
       << knock.yaw / kDegree << " deg";
}

class OnlineCalibrationKnock : public ::testing::TestWithParam<Knock> {};

TEST_P(OnlineCalibrationKnock, IsNoticedAndLearnedAnew) {
  const Knock knock = GetParam();
  for (std::uint64_t seed = 10; seed < 15; ++seed) {
    Camera camera(seed);
    OnlineCalibration calibration(nominal());
    camera.drive(calibration, 60);
    ASSERT_EQ(calibration.status(), CalibrationStatus::steady);
    camera.truth.roll += knock.roll;
    camera.truth.pitch += knock.pitch;
    camera.truth.yaw += knock.yaw;
    double noticed = 0;
    while (calibration.status() != CalibrationStatus::bumped && noticed < 10) {
      camera.drive(calibration, kFrame);
      noticed += kFrame;
    }
    EXPECT_LE(noticed, 3.0) << "seed " << seed;
    camera.drive(calibration, 60);
    EXPECT_EQ(calibration.status(), CalibrationStatus::steady);
    const Mounting& learned = calibration.pose().mounting;
    EXPECT_NEAR(learned.pitch, camera.truth.pitch, 0.15 * kDegree);
    EXPECT_NEAR(learned.yaw, camera.truth.yaw, 0.15 * kDegree);
    EXPECT_NEAR(learned.roll, camera.truth.roll, 0.35 * kDegree);
  }
}

INSTANTIATE_TEST_SUITE_P(OneDegree, OnlineCalibrationKnock,
                         ::testing::Values(Knock{0, kDegree, 0}, Knock{0, -kDegree, 0}, Knock{0, 0, kDegree},
                                           Knock{kDegree, 0, 0}, Knock{-kDegree, 0, 0}));

TEST(OnlineCalibration, AQuietDriveIsNoKnock) {
  for (std::uint64_t seed = 20; seed < 24; ++seed) {
    Camera camera(seed);
    OnlineCalibration calibration(nominal());
    camera.drive(calibration, 10);
    for (int i = 0; i < 200; ++i) {
      camera.drive(calibration, 1);
      ASSERT_NE(calibration.status(), CalibrationStatus::bumped)
          << "seed " << seed << ", after " << i << " s";
    }
  }
}

TEST(OnlineCalibration, LearnsNothingWhileTheCarCrawls) {
  Camera camera(4);
  camera.speed = 3;
  camera.truth.yaw += kDegree;
  OnlineCalibration calibration(nominal());
  camera.drive(calibration, 30);
  EXPECT_EQ(calibration.pose().mounting, nominal());
}

TEST(OnlineCalibration, SameTracksSamePose) {
  Camera one(5);
  Camera other(5);
  OnlineCalibration first(nominal());
  OnlineCalibration second(nominal());
  one.drive(first, 5);
  other.drive(second, 5);
  EXPECT_EQ(first.pose().mounting, second.pose().mounting);
}

}  // namespace
}  // namespace lanefuse
