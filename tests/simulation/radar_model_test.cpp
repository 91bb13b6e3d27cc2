// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/radar_model.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "simulation/detection_scene.hpp"
#include "simulation/scene_run.hpp"

namespace lanefuse {
namespace {

using testing::car;
using testing::exact_detections;
using testing::look;
using testing::Moments;
using testing::open_country;
using testing::road_rails;

constexpr double kDegree = std::numbers::pi / 180;

RadarModel long_range(const SensorPreset& preset, std::uint64_t seed = 1) {
  return {long_range_radar_setup(preset, road_rails()), seed};
}

RadarModel short_range(const SensorPreset& preset, int corner, std::uint64_t seed = 1) {
  return {short_range_radar_setup(preset, road_rails(), corner), seed};
}

Pose2 world_from(const SensorModel& radar, const SceneVehicle& ego) {
  const Mounting at = radar.description().mounting;
  return ego.world_from_vehicle * Pose2{at.x, at.y, at.yaw};
}

Eigen::Vector2d place_of(const RadarDetection& seen, const Pose2& world_from_radar) {
  const Eigen::Vector2d polar(std::cos(seen.bearing), std::sin(seen.bearing));
  return world_from_radar * Eigen::Vector2d(seen.range * polar);
}

SceneVehicle moved(SceneVehicle vehicle, double seconds) {
  vehicle.world_from_vehicle =
      vehicle.world_from_vehicle * constant_turn(vehicle.speed, vehicle.yaw_rate, seconds);
  return vehicle;
}

/// How far a point lies off the outline of the car, in its frame.
double off_outline(const Eigen::Vector2d& point) {
  const double off_end = std::min(std::abs(point.x()), std::abs(point.x() - 4.5));
  return std::min(off_end, std::abs(std::abs(point.y()) - 0.9));
}

/// Places on the car's outline, and range rates as the ranges change.
void expect_exact(RadarModel& radar, const Scene& scene) {
  int seen = 0;
  for (int scan = 0; scan < 20; ++scan) {
    for (const RadarDetection& detection : look<RadarScan>(radar, scene).detections) {
      const SceneVehicle& other = scene.vehicles.at(0);
      const Eigen::Vector2d point =
          other.world_from_vehicle.inverse() * place_of(detection, world_from(radar, scene.ego));
      EXPECT_NEAR(off_outline(point), 0, 1e-9);
      const auto range_in = [&](double seconds) {
        const Eigen::Vector2d there = moved(other, seconds).world_from_vehicle * point;
        return (world_from(radar, moved(scene.ego, seconds)).inverse() * there).norm();
      };
      EXPECT_NEAR(detection.range_rate, (range_in(1e-4) - range_in(-1e-4)) / 2e-4, 1e-4);
      ++seen;
    }
  }
  EXPECT_GE(seen, 15);
}

TEST(RadarModel, MeasuresAVehicleStraightAheadExactly) {
  RadarModel radar = long_range(exact_detections());
  const Scene scene = open_country(car(0, {10, 20, 0}, 30), {car(1, {10 + 0.9 + 60, 20, 0}, 25)});
  const RadarScan scan = look<RadarScan>(radar, scene);
  EXPECT_EQ(scan.stamp.received_at - scan.stamp.measured_at, std::chrono::milliseconds(40));
  ASSERT_FALSE(scan.detections.empty());
  for (const RadarDetection& detection : scan.detections) {
    EXPECT_NEAR(detection.range, 60, 0.01);
    EXPECT_NEAR(detection.bearing, 0, 0.9 / 60);
    EXPECT_NEAR(detection.range_rate, -5, 0.01);
  }
}

TEST(RadarModel, MeasuresRangeRatesInACurveWithItsOwnLeverArm) {
  const SceneVehicle ego = car(0, {10, 20, 0.3}, 30, 0.2);
  RadarModel ahead = long_range(exact_detections());
  const Pose2 in_front = ego.world_from_vehicle * Pose2{50, 4, 0.1};
  expect_exact(ahead, open_country(ego, {car(1, in_front, 24, 0.15)}));
  RadarModel corner = short_range(exact_detections(), 2);
  const Pose2 behind = ego.world_from_vehicle * Pose2{-14, 3.5, -0.1};
  expect_exact(corner, open_country(ego, {car(1, behind, 35, -0.1)}));
}

TEST(RadarModel, ErrsAsThePresetSays) {
  Moments range, rate, misalignment;
  double bearing_variance = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SensorPreset preset = exact_detections();
    preset.long_range_radar.reflections = {1, 1};
    RadarModel exact = long_range(preset, seed);
    const RadarPreset nominal = nominal_preset().long_range_radar;
    preset.long_range_radar.sigma_range = nominal.sigma_range;
    preset.long_range_radar.sigma_azimuth = nominal.sigma_azimuth;
    preset.long_range_radar.sigma_range_rate = nominal.sigma_range_rate;
    preset.long_range_radar.misalignment = nominal.misalignment;
    RadarModel noisy = long_range(preset, seed);
    const Scene scene = open_country(car(0, {}, 30), {car(1, {100, 0, 0}, 25)});
    Moments bearing;
    for (int i = 0; i < 100; ++i) {
      const RadarDetection truth = look<RadarScan>(exact, scene).detections.at(0);
      const RadarDetection seen = look<RadarScan>(noisy, scene).detections.at(0);
      range.add(seen.range - truth.range);
      rate.add(seen.range_rate - truth.range_rate);
      bearing.add((seen.bearing - truth.bearing) / kDegree);
    }
    bearing_variance += bearing.sigma() * bearing.sigma() / 60;
    misalignment.add(bearing.mean());
  }
  EXPECT_NEAR(range.rms(), 0.25, 0.01);
  EXPECT_NEAR(rate.rms(), 0.1, 0.005);
  EXPECT_NEAR(std::sqrt(bearing_variance), 0.15, 0.01);
  EXPECT_NEAR(misalignment.rms(), 0.08, 0.03);
}

TEST(RadarModel, DetectsAVehicleNowAndThenAndByAFewReflections) {
  SensorPreset preset = exact_detections();
  preset.long_range_radar.detection = 0.9;
  RadarModel radar = long_range(preset);
  const Scene scene = open_country(car(0, {}, 30), {car(1, {100, 0, 0}, 25)});
  Moments detected, reflections;
  for (int i = 0; i < 3000; ++i) {
    const std::size_t count = look<RadarScan>(radar, scene).detections.size();
    detected.add(count > 0);
    if (count > 0) reflections.add(static_cast<double>(count));
    EXPECT_LE(count, 3u);
  }
  EXPECT_NEAR(detected.mean(), 0.9, 0.02);
  EXPECT_NEAR(reflections.mean(), 2, 0.06);
}

TEST(RadarModel, SeesItsFieldAlone) {
  const SensorPreset preset = exact_detections();
  const auto sees = [](RadarModel radar, double x, double y) {
    const Scene scene = open_country(car(0, {}, 30), {car(1, {x, y, 0}, 30)});
    return !look<RadarScan>(radar, scene).detections.empty();
  };
  EXPECT_TRUE(sees(long_range(preset), 195, 0));
  EXPECT_FALSE(sees(long_range(preset), 205, 0));
  EXPECT_TRUE(sees(long_range(preset), 100, 12));
  EXPECT_FALSE(sees(long_range(preset), 100, 20));
  EXPECT_TRUE(sees(long_range(preset), 50, 20));
  EXPECT_FALSE(sees(long_range(preset), 30, 24));
  EXPECT_FALSE(sees(long_range(preset), -30, 0));
  for (int corner = 0; corner < kCorners; ++corner) {
    const int front = corner < 2 ? 1 : -1;
    const int left = corner % 2 == 0 ? 1 : -1;
    EXPECT_TRUE(sees(short_range(preset, corner), front * 20, left * 20));
    EXPECT_FALSE(sees(short_range(preset, corner), front * 50, left * 30));
    EXPECT_FALSE(sees(short_range(preset, corner), -front * 20, -left * 20));
  }
}

TEST(RadarModel, DoesNotSeeTheHidden) {
  RadarModel radar = long_range(exact_detections());
  const Scene scene =
      open_country(car(0, {}, 30), {car(1, {30, 0, 0}, 30), car(2, {80, 0, 0}, 30), car(3, {80, 8, 0}, 30)});
  std::set<int> seen;
  for (int i = 0; i < 30; ++i) {
    for (const RadarDetection& detection : look<RadarScan>(radar, scene).detections) {
      const Eigen::Vector2d place = place_of(detection, world_from(radar, scene.ego));
      seen.insert(place.x() < 60 ? 1 : (place.y() < 4 ? 2 : 3));
    }
  }
  EXPECT_EQ(seen, (std::set{1, 3}));
}

TEST(RadarModel, ReflectsAboutACentreThatWanders) {
  RadarModel radar = long_range(exact_detections());
  Scene scene = open_country(car(0, {}, 30), {car(1, {60, 0, 0}, 30)});
  Moments all, means;
  Moments half_second;
  for (int scan = 0; scan < 8000; ++scan, scene.time += from_seconds(0.0625)) {
    for (const RadarDetection& detection : look<RadarScan>(radar, scene).detections) {
      const Eigen::Vector2d place = place_of(detection, world_from(radar, scene.ego));
      ASSERT_LE(std::abs(place.y()), 0.9 + 1e-9);
      all.add(place.y() / 0.9);
      half_second.add(place.y() / 0.9);
    }
    if (scan % 8 != 7) continue;
    means.add(half_second.mean());
    half_second = {};
  }
  EXPECT_NEAR(all.mean(), 0, 0.04);
  EXPECT_NEAR(all.rms(), std::hypot(0.3, 0.3), 0.04);
  EXPECT_GT(means.rms(), 0.2);  // .1 if nothing lasted
  EXPECT_LT(means.rms(), 0.35);
}

TEST(RadarModel, GivesTheSameBytesForTheSameSeed) {
  const auto sum_of = [](std::uint64_t seed, int corner) {
    testing::SceneRun run(3);
    RadarModel radar = short_range(nominal_preset(), corner, seed);
    double sum = 0;
    run.watch(radar, 5, [&](const Scene&, const Measurement& measurement) {
      for (const RadarDetection& d : std::get<RadarScan>(measurement).detections)
        sum += d.range * d.bearing + d.range_rate;
    });
    return sum;
  };
  EXPECT_EQ(sum_of(1, 0), sum_of(1, 0));
  EXPECT_NE(sum_of(1, 0), sum_of(2, 0));
  EXPECT_NE(sum_of(1, 0), sum_of(1, 1));
}

TEST(RadarModel, SeesClutterThatMostlyStandsStill) {
  SensorPreset preset = exact_detections();
  preset.long_range_radar.clutter = 2;
  preset.long_range_radar.detection = 0;
  RadarModel radar = long_range(preset);
  testing::SceneRun run(1);
  double scans = 0, all = 0, standing = 0, beside = 0;
  std::multiset<int> places;  // decimetres along the world's axes, standing things alone
  run.watch(radar, 60, [&](const Scene& scene, const Measurement& measurement) {
    const Pose2 at = world_from(radar, scene.ego);
    const Eigen::Vector2d own = velocity_of(scene.ego, at.position());
    scans += 1;
    for (const RadarDetection& seen : std::get<RadarScan>(measurement).detections) {
      const Eigen::Vector2d place = place_of(seen, at);
      all += 1;
      if (std::abs(seen.range_rate + own.dot((place - at.position()).normalized())) > 1e-6) continue;
      standing += 1;
      places.insert(static_cast<int>(std::lround(place.x() * 100 + place.y() * 1000)));
      const Eigen::Vector2d on_road =
          testing::place_of(scene, scene.ego.world_from_vehicle.inverse() * place);
      beside += on_road.y() > scene.road->guard_rail(1, on_road.x()) - 0.1 ||
                on_road.y() < scene.road->guard_rail(-1, on_road.x()) + 0.1;
    }
  });
  EXPECT_NEAR(all / scans, 2, 0.15);
  EXPECT_NEAR(standing / all, 0.7, 0.04);
  EXPECT_GT(beside / standing, 0.6);
  const std::set<int> distinct(places.begin(), places.end());
  EXPECT_LT(static_cast<double>(distinct.size()), 0.4 * standing);
}

}  // namespace
}  // namespace lanefuse
