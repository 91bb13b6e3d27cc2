// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/disturbance.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "simulation/drive_simulation.hpp"

namespace lanefuse {
namespace {

std::vector<Measurement> drive_with(const std::vector<Disturbance>& disturbances, bool detections = false) {
  SimulationConfig config;
  config.detections = detections;
  config.km = 0.6;
  config.scenario.disturbances = disturbances;
  DriveSimulation simulation(config, nominal_preset());
  std::vector<Measurement> all, step;
  std::vector<TrueFrame> truth;
  while (simulation.step(step, truth)) all.insert(all.end(), step.begin(), step.end());
  return all;
}

double seconds_of(Time time) { return to_seconds(time - kSimulationStart); }

TEST(Disturbance, AGapSilencesAllButTheOdometry) {
  Disturbance gaps;
  gaps.first = 5;
  int in_gap = 0, odometry = 0;
  for (const Measurement& measurement : drive_with({gaps})) {
    const double at = seconds_of(stamp_of(measurement).measured_at);
    const bool inside = (at > 5 && at < 5.79) || (at > 15 && at < 15.79);
    (std::holds_alternative<VehicleMotion>(measurement) ? odometry : in_gap) += inside;
  }
  EXPECT_EQ(in_gap, 0);
  EXPECT_GT(odometry, 70);
}

TEST(Disturbance, LatencyIsALowerBound) {
  Disturbance latency{Disturbance::Kind::latency};
  latency.delay = 0.16;
  for (const Measurement& measurement : drive_with({latency})) {
    const Stamp& stamp = stamp_of(measurement);
    const bool odometry = std::holds_alternative<VehicleMotion>(measurement);
    ASSERT_EQ(stamp.received_at - stamp.measured_at, std::chrono::milliseconds(odometry ? 10 : 160));
  }
}

TEST(Disturbance, ShuffledMessagesOvertakeEachOtherAndNoneIsLost) {
  Disturbance shuffled{Disturbance::Kind::shuffled};
  shuffled.share = 0.5;
  shuffled.delay = 0.2;
  const std::vector<Measurement> usual = drive_with({});
  const std::vector<Measurement> mixed = drive_with({shuffled});
  EXPECT_EQ(mixed.size(), usual.size());
  int overtaken = 0;
  Time latest{};
  for (const Measurement& measurement : mixed) {
    if (!std::holds_alternative<MarkingFeatures>(measurement)) continue;
    overtaken += stamp_of(measurement).measured_at < latest;
    latest = std::max(latest, stamp_of(measurement).measured_at);
  }
  EXPECT_GT(overtaken, 10);
}

TEST(Disturbance, StaleMessagesComeLate) {
  Disturbance stale{Disturbance::Kind::stale};
  stale.delay = 1;
  double late = 0, all = 0;
  for (const Measurement& measurement : drive_with({stale})) {
    if (std::holds_alternative<VehicleMotion>(measurement)) continue;
    const Stamp& stamp = stamp_of(measurement);
    all += 1;
    late += to_seconds(stamp.received_at - stamp.measured_at) > 0.5;
  }
  EXPECT_NEAR(late / all, 0.1, 0.04);
}

TEST(Disturbance, CamerasSeeNothingInABlackoutAndNotFarAtNight) {
  Disturbance blackout{Disturbance::Kind::blackout};
  blackout.first = 200;
  blackout.every = 0;
  blackout.length = 90;
  Disturbance night{Disturbance::Kind::short_range};
  night.visibility = 45;
  int features_inside = 0, features_outside = 0;
  for (const Measurement& measurement : drive_with({blackout, night})) {
    const auto* frame = std::get_if<MarkingFeatures>(&measurement);
    if (!frame) continue;
    const double way = 30 * seconds_of(frame->stamp.measured_at);
    for (const Feature& feature : frame->features) ASSERT_LT(feature.x, 60);
    if (way > 215 && way < 275) features_inside += static_cast<int>(frame->features.size());
    if (way < 180 || way > 320) features_outside += static_cast<int>(frame->features.size());
  }
  EXPECT_EQ(features_inside, 0);
  EXPECT_GT(features_outside, 1000);
}

TEST(Disturbance, WhatBefallsObjectListsBefallsRadarsAndTheObjectCamera) {
  Disturbance gaps;
  gaps.first = 5;
  gaps.sensors = {SensorKind::object_fusion};
  Disturbance blackout{Disturbance::Kind::blackout};
  blackout.first = 300;
  blackout.every = 0;
  blackout.length = 90;
  int in_gap = 0, boxes_in_the_dark = 0, echoes_in_the_dark = 0;
  for (const Measurement& measurement : drive_with({gaps, blackout}, true)) {
    const double at = seconds_of(stamp_of(measurement).measured_at);
    const auto* scan = std::get_if<RadarScan>(&measurement);
    const auto* boxes = std::get_if<CameraBoxes>(&measurement);
    in_gap += (scan || boxes) && at > 5 && at < 5.79;
    if (30 * at < 315 || 30 * at > 375) continue;
    if (scan) echoes_in_the_dark += static_cast<int>(scan->detections.size());
    if (boxes) boxes_in_the_dark += static_cast<int>(boxes->boxes.size());
  }
  EXPECT_EQ(in_gap, 0);
  EXPECT_EQ(boxes_in_the_dark, 0);
  EXPECT_GT(echoes_in_the_dark, 100);
}

TEST(Disturbance, ChangesNeitherTheTrafficNorTheOtherSensors) {
  Disturbance gaps;
  gaps.sensors = {SensorKind::object_fusion};
  const auto features_of = [](const std::vector<Measurement>& all) {
    double sum = 0;
    for (const Measurement& measurement : all) {
      if (const auto* frame = std::get_if<MarkingFeatures>(&measurement)) {
        for (const Feature& feature : frame->features) sum += feature.y;
      }
    }
    return sum;
  };
  EXPECT_EQ(features_of(drive_with({gaps})), features_of(drive_with({})));
}

}  // namespace
}  // namespace lanefuse
