// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "road/noiseless_drive.hpp"
#include "road/road_estimator.hpp"

namespace lanefuse {
namespace {

using testing::kLane;
using testing::NoiselessDrive;

NoiselessDrive traffic(double curvature) {
  NoiselessDrive drive(curvature);
  std::int64_t track = 1;
  for (const double lane : {-1.0, 0.0, 1.0}) {
    for (const double ahead : {6.0, 30.0, 60.0}) {
      drive.vehicles.push_back(
          {track, ahead + static_cast<double>(track), [lane](double) { return lane * kLane; }});
      ++track;
    }
  }
  return drive;
}

class VehiclesAlone : public ::testing::TestWithParam<double> {};

TEST_P(VehiclesAlone, TellOfTheLanes) {
  NoiselessDrive drive = traffic(0);
  drive.speed = GetParam();
  RoadEstimator estimator{RoadConfig{}};
  const LaneEstimate& estimate = drive.run(estimator, 20);
  EXPECT_EQ(estimate.status, EstimateStatus::ok);
  ASSERT_EQ(estimate.lanes.size(), 3U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(lateral_at(estimate.boundaries[i], 20), kLane * (1.5 - static_cast<double>(i)), 0.4);
    EXPECT_GT(estimate.boundaries[i].support[static_cast<std::size_t>(Source::objects)], 0);
    EXPECT_GT(sigma_at(estimate.boundaries[i], 20), 0.05) << "and does not say that it knows them";
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, VehiclesAlone, ::testing::Values(3.0, 12.0, 30.0));

TEST(VehicleWitness, DoesNotDragTheRoadOnItsWayToAnotherLane) {
  for (const bool told : {true, false}) {
    NoiselessDrive drive = traffic(0);
    drive.paint_three_lanes();
    RoadEstimator estimator{RoadConfig{}};
    drive.run(estimator, 5);
    for (NoiselessDrive::Line& line : drive.lines) line.end = drive.station() + 60;
    drive.vehicles.back().offset = [](double seconds) {
      return kLane * (1 - std::clamp((seconds - 6) / 4, 0.0, 1.0));
    };
    double worst = 0;
    while (drive.seconds() < 11) {
      drive.advance();
      const bool changes = drive.seconds() > 6 && drive.seconds() < 10;
      for (Feature& feature : drive.sets().back().features) {
        feature.changing_lane = told && changes && feature.track_id == drive.vehicles.back().track;
      }
      const LaneEstimate& estimate = estimator.process(drive.cycle());
      ASSERT_EQ(estimate.lanes.size(), 3U);
      for (const Boundary& boundary : estimate.boundaries) {
        const double lateral = lateral_at(boundary, 60);
        const double line = kLane * (std::round(lateral / kLane - 0.5) + 0.5);
        worst = std::max(worst, std::abs(lateral - line));
      }
    }
    EXPECT_LT(worst, told ? 0.15 : 0.3) << told;
  }
}

}  // namespace
}  // namespace lanefuse
