// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/sensor_trust.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lanefuse {
namespace {

/// Looks every 50 ms from a car that drives straight on.
class Trust : public ::testing::Test {
 protected:
  SightingSet look(std::uint32_t sensor, std::vector<Sighting> sightings, double speed = 30) {
    SightingSet look;
    look.measured_at = now_;
    look.sensor_id = sensor;
    look.velocity = {speed, 0};
    look.field = {.range = 200, .half_angle = 0.5};
    look.sightings = std::move(sightings);
    return look;
  }
  bool believe(std::vector<Sighting> sightings, double speed = 30) {
    now_ += std::chrono::milliseconds(50);
    return trust_.believe(look(1, std::move(sightings), speed), 0);
  }
  static Sighting seen(double range, double bearing, double range_rate) {
    Sighting sighting{range, bearing, 0.2, 0.003};
    sighting.range_rate = range_rate;
    return sighting;
  }

  SensorTrust trust_{{}};
  Time now_ = from_nanoseconds(1'000'000'000);
};

TEST_F(Trust, IsGivenWhereNothingIsKnown) {
  EXPECT_TRUE(believe({}));
  EXPECT_TRUE(trust_.distrusted().empty());
  EXPECT_EQ(trust_.fault_of(1), SensorFault::none);
}

TEST_F(Trust, EndsWithTheSecondRepetitionOfWhatIsSeen) {
  const std::vector<Sighting> frozen{seen(40, 0.1, -1), seen(60, 0, 1)};
  EXPECT_TRUE(believe(frozen));
  EXPECT_TRUE(believe(frozen));
  EXPECT_FALSE(believe(frozen));
  EXPECT_EQ(trust_.fault_of(1), SensorFault::frozen);
  EXPECT_THAT(trust_.distrusted(), ::testing::ElementsAre(1U));
}

TEST_F(Trust, TakesNoStandstillForFrost) {
  const std::vector<Sighting> frozen{seen(40, 0.1, 0), seen(60, 0, 0)};
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(believe(frozen, 0));
}

TEST_F(Trust, TakesAnEmptyRoadForNothing) {
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(believe({}));
}

TEST_F(Trust, ComesBackAfterTwoSoundSeconds) {
  for (int i = 0; i < 5; ++i) believe({seen(40, 0.1, -1), seen(60, 0, 1)});
  int looks = 0;
  while (!believe({seen(40 + 0.01 * looks, 0.1, 0.2), seen(60, 0, 1)}) && looks < 200) ++looks;
  EXPECT_GE(looks, 39);
  EXPECT_LE(looks, 42);
}

TEST_F(Trust, EndsWithRangeRatesInKilometresAnHour) {
  int looks = 0;
  while (believe({seen(40 - looks, 0, -3.6 * 30), seen(80, 0.1, 0.01 * looks)}) && looks < 200) ++looks;
  EXPECT_LT(looks, 20);
  EXPECT_EQ(trust_.fault_of(1), SensorFault::range_rates);
}

TEST_F(Trust, EndsWithRangesThatDoNotChangeAsTheirRatesSay) {
  int looks = 0;
  const auto range = [&] { return 60 - 0.05 * 3 * looks; };
  while (believe({seen(range(), 0, -3 * 3.6)}) && looks < 200) ++looks;
  EXPECT_LT(looks, 40) << "two seconds";
  EXPECT_EQ(trust_.fault_of(1), SensorFault::range_rates);
}

TEST_F(Trust, StaysWhereRangesChangeAsTheirRatesSay) {
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(believe({seen(80 - 0.05 * 3 * i, 0, -3)})) << i;
}

TEST_F(Trust, EndsWithBearingsThatTheSensorCannotSee) {
  int looks = 0;
  while (believe({seen(40 + 0.01 * looks, 1.4, 0)}) && looks < 200) ++looks;
  EXPECT_LT(looks, 5);
  EXPECT_EQ(trust_.fault_of(1), SensorFault::beyond_field);
}

TEST_F(Trust, EndsWhereAnotherSeesOnTheLeftWhatIsSaidToBeOnTheRight) {
  int looks = 0;
  bool believed = true;
  for (; believed && looks < 200; ++looks) {
    now_ += std::chrono::milliseconds(50);
    SightingSet camera = look(2, {{40 + 0.01 * looks, 0.12, 2, 0.002}});
    camera.kind = SightingKind::camera;
    EXPECT_TRUE(trust_.believe(camera, 0));
    believed = trust_.believe(look(1, {seen(40 + 0.01 * looks, -0.12, 0.2)}), 0);
  }
  EXPECT_LT(looks, 40) << "two seconds";
  EXPECT_EQ(trust_.fault_of(1), SensorFault::mirrored);
  EXPECT_THAT(trust_.distrusted(), ::testing::ElementsAre(1U)) << "a camera needs two accusers";
}

TEST_F(Trust, IsNotLostToGhostsThatNobodyElseSees) {
  for (int i = 0; i < 200; ++i) {
    now_ += std::chrono::milliseconds(50);
    SightingSet camera = look(2, {{40 + 0.01 * i, 0.12, 2, 0.002}});
    camera.kind = SightingKind::camera;
    EXPECT_TRUE(trust_.believe(camera, 0)) << i;
    std::vector<Sighting> seen_by_radar{seen(40 + 0.01 * i, 0.12, 0.2)};
    for (int ghost = 0; ghost < 10; ++ghost)
      seen_by_radar.push_back(seen(50 + 5.0 * ghost + 0.01 * i, 0.2, 0.2));
    EXPECT_TRUE(trust_.believe(look(1, seen_by_radar), 0)) << i;
  }
}

/// Posts on both sides of a car that turns steadily to the left.
class InABend : public Trust {
 protected:
  static constexpr double kSpeed = 25;
  static constexpr double kYawRate = 0.03;

  /// Moves on, and brings the radar's look at the posts, with bearings as the fault has them.
  template <typename Fault>
  SightingSet posts(Fault fault, double yaw_rate = kYawRate) {
    now_ += std::chrono::milliseconds(50);
    car_ = car_ * Pose2{0.05 * kSpeed, 0, 0.05 * yaw_rate};
    SightingSet seen = look(1, {});
    seen.odometry_from_vehicle = seen.odometry_from_sensor = car_;
    seen.velocity = rotation(car_.heading) * Eigen::Vector2d(kSpeed, 0);
    seen.own_curvature = yaw_rate / kSpeed;
    if (posts_.empty() || (car_.inverse() * posts_.back()).x() < 70) {
      for (const double y : {9.0, -7.0}) posts_.push_back(car_ * Eigen::Vector2d(90 + y, y));
    }
    for (const Eigen::Vector2d& post : posts_) {
      const Eigen::Vector2d at = car_.inverse() * post;
      const double bearing = std::atan2(at.y(), at.x());
      if (at.x() < 15 || std::abs(bearing) > 0.45) continue;
      seen.sightings.push_back(InABend::seen(at.norm(), fault(bearing), -kSpeed * std::cos(bearing)));
    }
    return seen;
  }
  /// A camera's and the radar's word on one vehicle that is ahead to the left.
  static void add_vehicle(SightingSet& radar, double bearing) {
    radar.sightings.push_back(seen(60, bearing, 0.2));
  }
  SightingSet camera(double bearing) {
    SightingSet camera = look(2, {{60 + 0.001 * car_.x, bearing, 2, 0.002}});
    camera.kind = SightingKind::camera;
    camera.odometry_from_vehicle = camera.odometry_from_sensor = car_;
    return camera;
  }

  Pose2 car_;
  std::vector<Eigen::Vector2d> posts_;
};

constexpr auto kSound = [](double bearing) { return bearing; };

TEST_F(InABend, StandingThingsProveASoundRadar) {
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(trust_.believe(posts(kSound), 0)) << i;
}

TEST_F(InABend, StandingThingsBetrayAMirrorImage) {
  int looks = 0;
  while (trust_.believe(posts([](double bearing) { return -bearing; }), 0) && looks < 200) ++looks;
  EXPECT_LT(looks, 60) << "three seconds";
  EXPECT_EQ(trust_.fault_of(1), SensorFault::mirrored);
}

TEST_F(InABend, AProvenRadarIsRightAgainstAMirroredCamera) {
  for (int i = 0; i < 200; ++i) {
    SightingSet radar = posts(kSound);
    add_vehicle(radar, 0.08);
    trust_.believe(radar, 0);
    trust_.believe(camera(-0.08), 0);
  }
  EXPECT_THAT(trust_.distrusted(), ::testing::ElementsAre(2U));
  EXPECT_EQ(trust_.fault_of(2), SensorFault::mirrored);
}

TEST_F(InABend, ARadarThatWasSoundOnceIsNotProvenForEver) {
  for (int i = 0; i < 300; ++i) {
    const bool sound = i < 100;
    SightingSet radar = posts([&](double bearing) { return sound ? bearing : -bearing; });
    add_vehicle(radar, sound ? 0.08 : -0.08);
    trust_.believe(radar, 0);
    trust_.believe(camera(0.08), 0);
    EXPECT_NE(trust_.fault_of(2), SensorFault::mirrored) << i;
  }
  EXPECT_THAT(trust_.distrusted(), ::testing::ElementsAre(1U));
}

TEST_F(InABend, OnAStraightRoadNobodyCanTellAndTheRadarIsLeftOut) {
  for (int i = 0; i < 100; ++i) {
    SightingSet radar = posts(kSound, 0);
    add_vehicle(radar, 0.08);
    trust_.believe(radar, 0);
    trust_.believe(camera(-0.08), 0);
  }
  EXPECT_THAT(trust_.distrusted(), ::testing::ElementsAre(1U));
}

TEST_F(InABend, ARadarThatIsTurnedIsFoundByWhatStands) {
  for (const double turn : {-0.12, 0.12}) {
    for (const double yaw_rate : {0.0, kYawRate}) {
      trust_.reset();
      posts_.clear();
      int looks = 0;
      while (trust_.believe(posts([&](double bearing) { return bearing + turn; }, yaw_rate), 0) &&
             looks < 300)
        ++looks;
      EXPECT_LT(looks, 160) << "eight seconds; " << turn;
      // In a bend, what is turned goes askew as what is mirrored does.
      if (yaw_rate == 0) {
        EXPECT_EQ(trust_.fault_of(1), SensorFault::turned);
      }
    }
  }
}

TEST_F(InABend, ARadarThatIsTurnedALittleIsNot) {
  for (int i = 0; i < 300; ++i) {
    EXPECT_TRUE(trust_.believe(posts([](double bearing) { return bearing + 0.02; }), 0)) << i;
  }
}

TEST_F(InABend, ATurnedCameraIsFoundByAProvenRadar) {
  for (int i = 0; i < 300; ++i) {
    SightingSet radar = posts(kSound);
    add_vehicle(radar, 0.02);
    trust_.believe(radar, 0);
    trust_.believe(camera(0.02 + 0.12), 0);
  }
  EXPECT_THAT(trust_.distrusted(), ::testing::ElementsAre(2U));
  EXPECT_EQ(trust_.fault_of(2), SensorFault::turned);
}

TEST_F(InABend, ACameraIsBlindThatSeesNothingWhileTheRadarSeesAVehicleAhead) {
  for (const double range : {60.0, 190.0}) {
    trust_.reset();
    for (int i = 0; i < 100; ++i) {
      SightingSet radar = posts(kSound);
      radar.sightings.push_back(seen(range, 0.01, 0.2));
      EXPECT_TRUE(trust_.believe(radar, 0));
      SightingSet nothing = camera(0);
      nothing.sightings.clear();
      const bool believed = trust_.believe(nothing, 0);
      EXPECT_TRUE(believed || i >= 38) << "two seconds";
    }
    EXPECT_EQ(trust_.fault_of(2), range < 100 ? SensorFault::blind : SensorFault::none) << range;
  }
}

TEST_F(InABend, ACameraIsNotBlindForWhatStands) {
  for (int i = 0; i < 200; ++i) {
    trust_.believe(posts(kSound), 0);
    SightingSet nothing = camera(0);
    nothing.sightings.clear();
    EXPECT_TRUE(trust_.believe(nothing, 0)) << i;
  }
}

TEST_F(Trust, IsGivenAnewOnReset) {
  for (int i = 0; i < 5; ++i) believe({seen(40, 0.1, -1), seen(60, 0, 1)});
  trust_.reset();
  EXPECT_TRUE(believe({seen(40, 0.1, -1)}));
  EXPECT_TRUE(trust_.distrusted().empty());
}

}  // namespace
}  // namespace lanefuse
