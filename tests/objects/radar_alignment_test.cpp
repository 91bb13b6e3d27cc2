// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/radar_alignment.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kPeriod = 0.066;  ///< [s]
constexpr double kSpeed = 30;      ///< [m/s]
constexpr std::uint32_t kRadar = 6;

/// A car on a straight road with a post each 25 m to either side, and a radar that sees each now and then.
class Alignment : public ::testing::Test {
 protected:
  double turn_ = 0;           ///< [rad] of the radar
  double yaw_rate_bias_ = 0;  ///< [rad/s] of the dead reckoning
  double posts_speed_ = 0;    ///< [m/s] over ground

  void drive(RadarAlignment& alignment, double seconds) {
    for (const double until = now_ + seconds; now_ < until; now_ += kPeriod) alignment.look(look());
  }

  /// The drive so far of whoever looks with this bias: an arc instead of the straight line.
  SightingSet look() {
    SightingSet look;
    look.measured_at = Time{} + from_seconds(1 + now_);
    look.sensor_id = kRadar;
    look.odometry_from_vehicle = constant_turn(kSpeed, yaw_rate_bias_, now_);
    look.odometry_from_sensor = look.odometry_from_vehicle;
    look.velocity = rotation(look.odometry_from_vehicle.heading) * Eigen::Vector2d(kSpeed, 0);
    for (int post = first_post(); 25 * post < kSpeed * now_ + 180; ++post) {
      for (const double y : {9.0, -7.0}) see({25 * post + y - kSpeed * now_, y}, look);
    }
    return look;
  }

 private:
  double now_ = 0;
  Random random_{7, "posts"};

  [[nodiscard]] int first_post() const { return static_cast<int>(std::ceil(kSpeed * now_ / 25)) + 1; }

  void see(const Eigen::Vector2d& at, SightingSet& look) {
    if (!random_.chance(0.2)) return;
    Sighting& post = look.sightings.emplace_back();
    post.range = at.norm() + random_.normal(0.25);
    post.bearing_sigma = 0.2 * kDegree;
    post.bearing = std::atan2(at.y(), at.x()) + turn_ + random_.normal(post.bearing_sigma);
    post.range_rate = (posts_speed_ - kSpeed) * at.x() / at.norm();
  }
};

TEST_F(Alignment, FindsByHowMuchARadarIsTurned) {
  for (const double degrees : {-0.2, 0.1, 0.3}) {
    turn_ = degrees * kDegree;
    RadarAlignment alignment({});
    drive(alignment, 100);
    const RadarAlignment::Offset offset = alignment.offset_of(kRadar);
    EXPECT_NEAR(offset.value, turn_, 3 * offset.sigma) << degrees;
    EXPECT_LT(offset.sigma, 0.05 * kDegree);
  }
}

TEST_F(Alignment, TakesABiasOfTheYawRateForNoTurn) {
  yaw_rate_bias_ = 0.05 * kDegree;
  RadarAlignment alignment({});
  drive(alignment, 200);
  const RadarAlignment::Offset offset = alignment.offset_of(kRadar);
  EXPECT_NEAR(offset.value, 0, 3 * offset.sigma);
  EXPECT_LT(std::abs(offset.value), 0.1 * kDegree);
}

TEST_F(Alignment, TakesWhatIsKnownOffRadarsBearings) {
  turn_ = 0.2 * kDegree;
  RadarAlignment alignment({});
  drive(alignment, 60);
  const double known = alignment.offset_of(kRadar).value;
  EXPECT_GT(known, 0.05 * kDegree);
  SightingSet seen;
  seen.sensor_id = kRadar;
  seen.sightings = {{50, 0.1}};
  alignment.correct(seen);
  EXPECT_DOUBLE_EQ(seen.sightings[0].bearing, 0.1 - known);
  seen.sensor_id = kRadar + 1;
  alignment.correct(seen);
  EXPECT_DOUBLE_EQ(seen.sightings[0].bearing, 0.1 - known) << "another radar";
}

TEST_F(Alignment, FindsNothingWhereNothingStands) {
  turn_ = 0.3 * kDegree;
  posts_speed_ = 25;
  RadarAlignment alignment({});
  drive(alignment, 60);
  EXPECT_EQ(alignment.offset_of(kRadar).value, 0);
  EXPECT_NEAR(alignment.offset_of(kRadar).sigma, RadarAlignmentConfig{}.sigma_deg * kDegree, 1e-3 * kDegree);
}

TEST_F(Alignment, CorrectsNoMoreThanItMay) {
  RadarAlignmentConfig config;
  config.most_deg = 0.1;
  turn_ = 0.5 * kDegree;
  RadarAlignment alignment(config);
  drive(alignment, 100);
  EXPECT_DOUBLE_EQ(alignment.offset_of(kRadar).value, 0.1 * kDegree);
}

TEST_F(Alignment, IsNotFooledByMirrorImagesOfVehiclesAndOfRails) {
  RadarAlignment alignment({});
  Random random(3, "mirrors");
  for (int i = 0; i < 1500; ++i) {
    SightingSet seen = look();
    // Beyond the rail and closing in on us sideways, as fast as what it mirrors; and a glint of the rail.
    Sighting vehicle = {80 - 0.02 * (i % 1000), 0.12 + 0.0001 * (i % 1000), 0.25, 0.0035};
    vehicle.range_rate = -0.3;
    Sighting glint = {30 + random.normal(0.25), 0.25 + random.normal(0.0035), 0.25, 0.0035};
    glint.range_rate = 0;
    seen.sightings.push_back(vehicle);
    seen.sightings.push_back(glint);
    alignment.look(seen);
    drive(alignment, kPeriod / 2);
  }
  const RadarAlignment::Offset offset = alignment.offset_of(kRadar);
  EXPECT_NEAR(offset.value, 0, 3 * offset.sigma);
}

TEST_F(Alignment, IsLeftAloneWhereItIsSwitchedOff) {
  RadarAlignmentConfig config;
  config.enabled = false;
  turn_ = 0.3 * kDegree;
  RadarAlignment alignment(config);
  drive(alignment, 60);
  EXPECT_EQ(alignment.offset_of(kRadar).value, 0);
}

}  // namespace
}  // namespace lanefuse
