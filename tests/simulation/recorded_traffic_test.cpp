// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/recorded_traffic.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "simulation/replay_simulation.hpp"
#include "simulation/scene_run.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

using testing::Moments;

/// A car that follows a bend at 10 Hz, stops for `stop` seconds in the middle, and goes on; recorded with
/// noise.
RecordedVehicle bending_car(double noise, double stop, std::uint64_t seed) {
  Random random(seed, "recording");
  RecordedVehicle car;
  car.id = 7;
  double way = 0;
  for (int i = 0; i < 150; ++i) {
    const double time = 0.1 * i;
    const bool stands = time >= 6 && time < 6 + stop;
    const double speed = stands ? 0 : 12 * std::min(1.0, std::abs(time - 6 - (time > 6 ? stop : 0)) / 4);
    way += 0.1 * speed;
    const double heading = 0.3 + way / 400;
    car.states.push_back({time, 400 * (std::sin(heading) - std::sin(0.3)) + random.normal(noise),
                          400 * (std::cos(0.3) - std::cos(heading)) + random.normal(noise), heading, speed});
  }
  return car;
}

void expect_derivatives(const RecordedMotion& motion) {
  const double dt = 0.001;
  for (double time = motion.begin(); time < motion.end() - dt; time += 0.013) {
    const RecordedMotion::State before = motion.at(time);
    const RecordedMotion::State after = motion.at(time + dt);
    const Pose2 step = before.pose.inverse() * after.pose;
    ASSERT_NEAR(step.x / dt, (before.speed + after.speed) / 2, 0.02) << "at " << time;
    ASSERT_NEAR(step.y, 0, 1e-5) << "slips at " << time;
    ASSERT_NEAR(step.heading / dt, (before.yaw_rate + after.yaw_rate) / 2, 0.01) << "at " << time;
    ASSERT_GE(before.speed, 0);
    ASSERT_GE(after.way, before.way - 1e-9);
  }
}

RC_GTEST_PROP(RecordedMotion, HeadingSpeedAndYawRateAreTheDerivativesOfThePlace, (std::uint64_t seed)) {
  const double stop = *rc::gen::element(0.0, 3.0, 8.0);
  const double ahead = *rc::gen::element(-7.0, -2.2, 0.0, 1.4);
  expect_derivatives(RecordedMotion(bending_car(0.1, stop, seed), ahead));
}

TEST(RecordedMotion, KeepsToTheRecordedPlaces) {
  Moments off, heading, speed;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const RecordedVehicle exact = bending_car(0, 3, seed);
    const RecordedMotion motion(bending_car(0.1, 3, seed), 0);
    for (const RecordedState& state : exact.states) {
      const RecordedMotion::State now = motion.at(state.time_s);
      off.add(std::hypot(now.pose.x - state.x, now.pose.y - state.y));
      heading.add(wrap_angle(now.pose.heading - state.heading));
      speed.add(now.speed - state.speed);
    }
  }
  EXPECT_LT(off.rms(), 0.15);  // closer than the noise of a single place
  EXPECT_LT(heading.rms(), 0.02);
  EXPECT_LT(speed.rms(), 0.8);
}

TEST(RecordedMotion, IsOfThePointAskedFor) {
  const RecordedVehicle car = bending_car(0, 0, 1);
  const RecordedMotion middle(car, 0), rear(car, -2.25);
  for (double time = 0.5; time < 14; time += 0.5) {
    const Pose2 offset = middle.at(time).pose.inverse() * rear.at(time).pose;
    EXPECT_NEAR(offset.x, -2.25, 0.02);
    EXPECT_NEAR(offset.y, 0, 0.02);
  }
}

TEST(RecordedMotion, AVehicleThatStandsKeepsItsPlaceAndHeading) {
  Random random(3, "recording");
  RecordedVehicle car;
  for (int i = 0; i < 80; ++i)
    car.states.push_back({0.1 * i, 5 + random.normal(0.05), 9 + random.normal(0.05), -0.7, 0});
  const RecordedMotion motion(car, 0);
  for (double time = 0; time < 7.9; time += 0.1) {
    EXPECT_NEAR(motion.at(time).pose.x, 5, 0.2);
    EXPECT_NEAR(motion.at(time).pose.y, 9, 0.2);
    EXPECT_NEAR(motion.at(time).pose.heading, -0.7, 0.05);
    EXPECT_LT(motion.at(time).speed, 0.3);
  }
}

TEST(RecordedMotion, OneStateIsEnough) {
  RecordedVehicle car;
  car.states.push_back({2, 1, -3, 0.5, 10});
  const RecordedMotion motion(car, -2);
  EXPECT_EQ(motion.begin(), motion.end());
  EXPECT_NEAR(motion.at(2).pose.x, 1 - 2 * std::cos(0.5), 1e-3);
  EXPECT_NEAR(motion.at(2).pose.heading, 0.5, 1e-3);
}

CommonRoadScenario two_cars() {
  CommonRoadScenario scenario;
  scenario.vehicles = {bending_car(0, 0, 1), bending_car(0, 0, 1)};
  scenario.vehicles[1].id = 8;
  scenario.vehicles[1].length = 10;
  for (RecordedState& state : scenario.vehicles[1].states) {
    state.x += 30 * std::cos(0.3);
    state.y += 30 * std::sin(0.3);
  }
  scenario.vehicles[1].states.resize(100);
  return scenario;
}

TEST(RecordedTraffic, ShowsTheEgoCarByItsFrontAxleAndTheOthersByTheirRear) {
  RecordedTraffic traffic(two_cars().vehicles, 7);
  const Scene scene = traffic.scene(Time{});
  ASSERT_EQ(scene.vehicles.size(), 1u);
  EXPECT_EQ(scene.ego.id, kEgoId);
  EXPECT_EQ(scene.vehicles[0].id, 8);
  const Pose2 rear = scene.ego.world_from_vehicle.inverse() * scene.vehicles[0].world_from_vehicle;
  EXPECT_NEAR(rear.x, 30 - 5 - (4.5 / 2 - RecordedTraffic::kFrontOverhang), 0.1);
  EXPECT_EQ(scene.vehicles[0].front, 10);
  EXPECT_NEAR(scene.ego.front + scene.ego.rear, 4.5, 1e-12);
}

TEST(RecordedTraffic, ForgetsWhoWasRecordedNoLonger) {
  RecordedTraffic traffic(two_cars().vehicles, 7);
  EXPECT_EQ(traffic.progress(), 0);
  for (int tick = 0; tick < 11 * 50; ++tick) traffic.advance(0.02);
  EXPECT_TRUE(traffic.scene(Time{}).vehicles.empty());
  EXPECT_FALSE(traffic.is_over());
  for (int tick = 0; tick < 4 * 50; ++tick) traffic.advance(0.02);
  EXPECT_TRUE(traffic.is_over());
  EXPECT_EQ(traffic.progress(), 1);
}

TEST(RecordedTraffic, KnowsWhoStayedLongest) {
  const CommonRoadScenario scenario = two_cars();
  EXPECT_EQ(longest_stay(scenario.vehicles).id, 7);
  EXPECT_EQ(find_vehicle(scenario.vehicles, 9), nullptr);
}

TEST(ReplaySimulation, GivesOdometryAndObjectsAndTheTruthOfBoth) {
  ReplaySimulation simulation(two_cars(), {"two cars", 7}, nominal_preset());
  EXPECT_EQ(simulation.rig().sensors.size(), 2u);
  EXPECT_FALSE(simulation.rig().has_camera());
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  std::size_t motions = 0, objects = 0, frames = 0;
  while (simulation.step(measurements, truth)) {
    frames += truth.size();
    for (const Measurement& measurement : measurements) {
      ASSERT_FALSE(implausible(measurement));
      motions += std::holds_alternative<VehicleMotion>(measurement);
      if (const auto* list = std::get_if<ObjectList>(&measurement)) objects += list->objects.size();
    }
  }
  EXPECT_NEAR(static_cast<double>(motions), 14.9 * 50, 2);
  EXPECT_NEAR(static_cast<double>(frames), 14.9 * 12.5, 2);
  EXPECT_NEAR(static_cast<double>(objects), 9.9 * 12.5, 3);
}

TEST(ReplaySimulation, GivesDetectionsInsteadOfObjects) {
  ReplaySimulation simulation(two_cars(), {"two cars", 7, 1, true, 4}, nominal_preset());
  EXPECT_EQ(simulation.info().name,
            "replayed, two cars, ego 7, seed 1, detections, up to 4 guard-rail mirrors");
  EXPECT_EQ(simulation.rig().sensors.size(), 7u);
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  std::size_t echoes = 0, lists = 0;
  while (simulation.step(measurements, truth)) {
    for (const Measurement& measurement : measurements) {
      lists += std::holds_alternative<ObjectList>(measurement);
      if (const auto* scan = std::get_if<RadarScan>(&measurement)) echoes += scan->detections.size();
    }
  }
  EXPECT_EQ(lists, 0u);
  EXPECT_GT(echoes, 20u);
}

TEST(ReplaySimulation, RefusesAnEgoCarThatIsNotThere) {
  try {
    ReplaySimulation(two_cars(), {"two.xml", 9}, nominal_preset());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    EXPECT_NE(std::string(error.what()).find("two.xml: has no recorded vehicle 9"), std::string::npos);
  }
}

TEST(RecordedTraffic, Us101IsSmoothAndStaysWhereItWasRecorded) {
  const auto folder = testing::real_data("commonroad");
  LANEFUSE_NEEDS_DATA(folder);
  Moments off, speed;
  for (const char* name : {"USA_US101-4_1_T-1.xml", "USA_US101-15_1_T-1.xml", "USA_US101-24_2_T-1.xml"}) {
    for (const RecordedVehicle& vehicle : read_commonroad(folder / name).vehicles) {
      const RecordedMotion motion(vehicle, 0);
      expect_derivatives(motion);
      for (const RecordedState& state : vehicle.states) {
        const RecordedMotion::State now = motion.at(state.time_s);
        const double distance = std::hypot(now.pose.x - state.x, now.pose.y - state.y);
        ASSERT_LT(distance, 2) << name << " " << vehicle.id;
        off.add(distance);
        speed.add(now.speed - state.speed);
      }
    }
  }
  EXPECT_GT(off.count(), 5000);
  EXPECT_LT(off.rms(), 0.15);
  EXPECT_LT(speed.rms(), 0.5);
}

}  // namespace
}  // namespace lanefuse
