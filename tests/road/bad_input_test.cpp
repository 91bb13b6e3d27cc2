// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Whatever comes in is counted, and nothing of it breaks the state.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "road/noiseless_drive.hpp"
#include "road/road_estimator.hpp"

namespace lanefuse {
namespace {

using testing::kLane;
using testing::NoiselessDrive;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::uint64_t items_in(const Cycle& cycle) {
  std::uint64_t items = 0;
  for (const FeatureSet& set : cycle.features) items += set.features.size() + set.clothoids.size();
  return items;
}

void expect_counted(const InputAccounting& inputs, const Cycle& cycle) {
  ASSERT_EQ(inputs.used + inputs.rejected + inputs.dropped, items_in(cycle));
}

void expect_sound(const RoadState& state) {
  const GaussianState& numbers = state.numbers();
  Eigen::MatrixXd covariance(numbers.size(), numbers.size());
  for (int i = 0; i < numbers.size(); ++i) {
    ASSERT_TRUE(std::isfinite(numbers.mean(i))) << i;
    ASSERT_GT(numbers.variance(i), 0) << i;
    for (int j = 0; j < numbers.size(); ++j) {
      covariance(i, j) = numbers.covariance(i, j) / std::sqrt(numbers.variance(i) * numbers.variance(j));
    }
  }
  ASSERT_TRUE(covariance.allFinite());
  ASSERT_GT(covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-9);
}

/// A drive on which everything is told: paint, vehicles, and the serial camera's lane.
NoiselessDrive full_drive() {
  NoiselessDrive drive(3e-4);
  drive.paint_three_lanes();
  drive.vehicles = {{1, 30, [](double) { return kLane; }}, {2, 50, [](double) { return 0.0; }}};
  return drive;
}

void add_tracked_lane(NoiselessDrive& drive) {
  FeatureSet& set = drive.sets().emplace_back();
  set.source = Source::serial_camera;
  set.sensor_id = 1;
  set.measured_at = drive.now();
  for (const Side side : {Side::left, Side::right}) {
    ClothoidMeasurement& one = set.clothoids.emplace_back();
    one.clothoid = {side == Side::left ? kLane / 2 : -kLane / 2, 0, 3e-4, 0};
    one.covariance = Eigen::Vector4d(0.03, 0.003, 1e-4, 1e-6).cwiseAbs2().asDiagonal();
    one.range_end = 60;
    one.side = side;
  }
}

struct Fault {
  std::string name;
  std::function<void(Feature&)> feature;
  std::function<void(ClothoidMeasurement&)> clothoid;
};

class Impossible : public ::testing::TestWithParam<Fault> {};

/// A tenth of all items is impossible: they are rejected, all of them, and the lanes are what they were.
TEST_P(Impossible, IsRejectedAndCounted) {
  NoiselessDrive drive = full_drive();
  RoadEstimator estimator{RoadConfig{}};
  Random random(7, "faults");
  for (int cycle = 0; cycle < 150; ++cycle) {
    drive.advance();
    add_tracked_lane(drive);
    std::uint64_t faults = 0;
    for (FeatureSet& set : drive.sets()) {
      for (Feature& feature : set.features) {
        if (!random.chance(0.1)) continue;
        GetParam().feature(feature);
        ++faults;
      }
      for (ClothoidMeasurement& clothoid : set.clothoids) {
        if (!random.chance(0.1)) continue;
        GetParam().clothoid(clothoid);
        ++faults;
      }
    }
    const LaneEstimate& estimate = estimator.process(drive.cycle());
    expect_counted(estimate.inputs, drive.cycle());
    EXPECT_EQ(estimate.inputs.rejected, faults);
    expect_sound(estimator.state());
    if (cycle < 50) continue;
    ASSERT_EQ(estimate.status, EstimateStatus::ok) << cycle;
    ASSERT_EQ(estimate.lanes.size(), 3U) << cycle;
    const Boundary* left = find_boundary(estimate, ego_lane(estimate)->left_boundary);
    ASSERT_NEAR(lateral_at(*left, 50), drive.lateral_of(drive.lines[1].offset, 50), 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Inputs, Impossible,
    ::testing::Values(
        Fault{"NoPlace", [](Feature& f) { f.x = kNan; }, [](auto& c) { c.clothoid.lateral_offset = kNan; }},
        Fault{"NoHeading", [](Feature& f) { f.heading = kNan; },
              [](auto& c) { c.clothoid.heading = kInfinite; }},
        Fault{"TooFar", [](Feature& f) { f.y = -1e4; }, [](auto& c) { c.clothoid.curvature = 1e5; }},
        Fault{"Infinite", [](Feature& f) { f.x = kInfinite; }, [](auto& c) { c.range_end = kNan; }},
        Fault{"NoConfidence", [](Feature& f) { f.confidence = kNan; },
              [](auto& c) { c.clothoid.curvature_rate = 1e300; }},
        Fault{"NoCovariance", [](Feature& f) { f.covariance(0, 1) = kNan; },
              [](auto& c) { c.covariance(2, 3) = kNan; }},
        Fault{"NegativeVariance", [](Feature& f) { f.covariance(1, 1) = -1; },
              [](auto& c) { c.covariance(0, 0) = -1; }},
        Fault{"NoVariance", [](Feature& f) { f.covariance.setZero(); },
              [](auto& c) { c.covariance(1, 1) = kNan; }},
        Fault{"EndlessVariance", [](Feature& f) { f.covariance *= 1e300; },
              [](auto& c) { c.covariance *= 1e300; }}),
    [](const auto& one) { return one.param.name; });

TEST(BadInput, PaintAtTheCarItselfIsHarmless) {
  NoiselessDrive drive = full_drive();
  RoadEstimator estimator{RoadConfig{}};
  for (int cycle = 0; cycle < 100; ++cycle) {
    drive.advance();
    for (const double x : {0.0, -5.0, 1e-9, 159.99, 160.0, 999.0}) {
      drive.sets().front().features.push_back(NoiselessDrive::feature({x, 0, 3}));
    }
    expect_counted(estimator.process(drive.cycle()).inputs, drive.cycle());
    expect_sound(estimator.state());
  }
  EXPECT_EQ(estimator.process(drive.cycle()).lanes.size(), 3U);
}

TEST(BadInput, EmptySetsAndEmptyCyclesAreTaken) {
  NoiselessDrive drive = full_drive();
  RoadEstimator estimator{RoadConfig{}};
  drive.run(estimator, 2);
  for (int cycle = 0; cycle < 50; ++cycle) {
    drive.advance();
    if (cycle % 2 == 0) drive.sets().clear();
    for (FeatureSet& set : drive.sets()) set.features.clear();
    EXPECT_EQ(estimator.process(drive.cycle()).inputs, InputAccounting{});
  }
  drive.advance();
  EXPECT_EQ(estimator.process(drive.cycle()).lanes.size(), 3U) << "and the lanes are still known";
}

/// Ten thousand points of anything, as no camera gives them.
TEST(BadInput, ThousandsOfFeaturesAreTaken) {
  NoiselessDrive drive = full_drive();
  RoadEstimator estimator{RoadConfig{}};
  Random random(4, "crowd");
  for (int cycle = 0; cycle < 10; ++cycle) {
    drive.advance();
    for (int i = 0; i < 5000; ++i) {
      const Pose2 place{random.uniform(-20, 200), random.uniform(-20, 20), random.normal(1)};
      drive.sets()[0].features.push_back(NoiselessDrive::feature(place));
      Feature& witness = drive.sets()[1].features.emplace_back(NoiselessDrive::feature(place));
      witness.track_id = random.whole(0, 700);
      witness.side = random.chance(0.5) ? Side::left : Side::right;
    }
    expect_counted(estimator.process(drive.cycle()).inputs, drive.cycle());
    expect_sound(estimator.state());
    EXPECT_LE(estimator.state().lines().size(), RoadState::kMostLines);
    EXPECT_LE(estimator.state().vehicles().size(), RoadState::kMostVehicles);
  }
}

TEST(BadInput, NoiseAloneBreaksNothing) {
  NoiselessDrive drive;
  drive.vehicles = full_drive().vehicles;
  RoadEstimator estimator{RoadConfig{}};
  Random random(9, "noise");
  for (int cycle = 0; cycle < 300; ++cycle) {
    drive.advance();
    add_tracked_lane(drive);
    FeatureSet& paint = drive.sets().emplace_back();
    paint.measured_at = drive.now();
    for (int i = 0; i < 60; ++i) {
      paint.features.push_back(
          NoiselessDrive::feature({random.uniform(3, 120), random.uniform(-9, 9), random.normal(0.1)}));
    }
    for (FeatureSet& set : drive.sets()) {
      for (ClothoidMeasurement& clothoid : set.clothoids) {
        clothoid.clothoid.heading = random.normal(0.2);
        clothoid.clothoid.curvature = random.normal(0.01);
        clothoid.clothoid.lateral_offset = random.normal(4);
      }
      for (Feature& feature : set.features) {
        if (feature.track_id != kNoTrack) feature.y += random.normal(4);
      }
    }
    const LaneEstimate& estimate = estimator.process(drive.cycle());
    expect_counted(estimate.inputs, drive.cycle());
    expect_sound(estimator.state());
    for (const Boundary& boundary : estimate.boundaries) {
      ASSERT_TRUE(boundary.clothoid.vector().allFinite());
      ASSERT_TRUE(boundary.covariance.allFinite());
      for (const BoundaryPoint& point : boundary.points) {
        ASSERT_TRUE(std::isfinite(point.y) && std::isfinite(point.sigma));
      }
    }
  }
}

TEST(BadInput, LateSetsAreMovedOrDropped) {
  NoiselessDrive drive = full_drive();
  RoadEstimator estimator{RoadConfig{}};
  drive.run(estimator, 3);
  std::vector<FeatureSet> late;
  for (int cycle = 0; cycle < 50; ++cycle) {
    drive.advance();
    std::vector<FeatureSet> fresh = drive.sets();
    drive.sets() = late;  // a cycle old
    late = fresh;
    const LaneEstimate& estimate = estimator.process(drive.cycle());
    expect_counted(estimate.inputs, drive.cycle());
    ASSERT_EQ(estimate.lanes.size(), 3U);
    const Boundary* left = find_boundary(estimate, ego_lane(estimate)->left_boundary);
    ASSERT_NEAR(lateral_at(*left, 60), drive.lateral_of(drive.lines[1].offset, 60), 0.02);
  }
  drive.advance();
  for (FeatureSet& set : drive.sets()) set.measured_at -= std::chrono::seconds(30);
  const std::uint64_t items = items_in(drive.cycle());
  EXPECT_EQ(estimator.process(drive.cycle()).inputs, (InputAccounting{0, 0, items}));
}

TEST(BadInput, WithoutMotionThereIsNoEstimateAndAllIsCounted) {
  NoiselessDrive drive = full_drive();
  RoadEstimator estimator{RoadConfig{}};
  drive.run(estimator, 3);
  const auto sound = drive.motion();
  for (const int fault : {0, 1, 2}) {
    drive.advance();
    if (fault == 0) drive.motion().clear();
    if (fault == 1) drive.motion() = sound;  // long past
    if (fault == 2) drive.motion().back().odometry_from_vehicle.heading = kNan;
    Cycle cycle = drive.cycle();
    if (fault == 1) cycle.time += std::chrono::seconds(1);
    const LaneEstimate& estimate = estimator.process(cycle);
    EXPECT_EQ(estimate.status, EstimateStatus::invalid);
    EXPECT_EQ(estimate.reason, StatusReason::no_motion);
    EXPECT_TRUE(estimate.boundaries.empty());
    EXPECT_TRUE(estimate.lanes.empty());
    expect_counted(estimate.inputs, drive.cycle());
    expect_sound(estimator.state());
  }
  NoiselessDrive again = full_drive();
  estimator.reset();
  EXPECT_EQ(again.run(estimator, 3).lanes.size(), 3U);
}

TEST(BadInput, AnImpossibleLaneWidthIsNone) {
  NoiselessDrive drive = full_drive();
  RoadEstimator estimator{RoadConfig{}};
  for (const double width : {kNan, -3.0, 0.0, 1e9}) {
    drive.advance();
    drive.sets().back().lane_width = LaneWidth{width, 0.1};
    const LaneEstimate& estimate = estimator.process(drive.cycle());
    expect_counted(estimate.inputs, drive.cycle());
    EXPECT_EQ(estimate.inputs.rejected, 0U) << "the vehicles are where they are";
    expect_sound(estimator.state());
  }
}

}  // namespace
}  // namespace lanefuse
