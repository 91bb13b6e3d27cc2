// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/simulated_run.hpp"

namespace lanefuse {
namespace {

/// The graph's size, cycle by cycle.
class GraphSizes {
 public:
  void feed(MultiLanePerception& perception, const Measurement& measurement) {
    while (const LaneEstimate* lanes = perception.advance(stamp_of(measurement).received_at)) {
      last_ = *lanes;
      sizes_.push_back(perception.debug().graph);
    }
    perception.add(measurement);
  }
  [[nodiscard]] std::size_t cycles() const { return sizes_.size(); }
  [[nodiscard]] const LaneEstimate& last() const { return last_; }
  /// The largest graph of the cycles in this share of the run.
  [[nodiscard]] GraphSize largest(double from, double to) const {
    const auto at = [&](double share) {
      return static_cast<std::size_t>(share * static_cast<double>(sizes_.size()));
    };
    GraphSize most;
    for (std::size_t i = at(from); i < at(to); ++i) {
      most.poses = std::max(most.poses, sizes_[i].poses);
      most.features = std::max(most.features, sizes_[i].features);
      most.edges = std::max(most.edges, sizes_[i].edges);
    }
    return most;
  }

 private:
  std::vector<GraphSize> sizes_;
  LaneEstimate last_;
};

void expect_no_growth(const GraphSize& early, const GraphSize& late) {
  EXPECT_LE(late.poses, 1.3 * early.poses + 5);
  EXPECT_LE(late.features, 1.3 * early.features + 20);
  EXPECT_LE(late.edges, 1.3 * early.edges + 100);
}

TEST(BoundedMemory, TheGraphOfALongDriveIsThatOfAShortOne) {
  DriveSimulation simulation({4, 6}, nominal_preset());
  MultiLanePerception perception({}, simulation.rig());
  GraphSizes graph;
  std::vector<Measurement> measurements;
  std::vector<TrueFrame> truth;
  while (simulation.step(measurements, truth)) {
    for (const Measurement& measurement : measurements) graph.feed(perception, measurement);
  }
  EXPECT_GT(graph.cycles(), 2000U);
  expect_no_growth(graph.largest(0, 0.3), graph.largest(0.3, 1));
}

/// A traffic jam that stands: the cameras see the same paint again and again, with noise and with false bars,
/// and vehicles crawl by on both sides.
class StandingCar {
 public:
  std::vector<Measurement> tick(int tick) {
    const Time now = Time{std::chrono::seconds(1000)} + std::chrono::milliseconds(40) * tick;
    std::vector<Measurement> measurements;
    measurements.push_back(VehicleMotion{{now, now, 0}, 0.0, 0.002 * noise()});
    if (tick % 5 == 0) measurements.push_back(markings({now, now, 2}));
    if (tick % 5 == 0) measurements.push_back(vehicles({now, now, 3}, 0.04 * tick));
    return measurements;
  }

 private:
  double noise() { return static_cast<double>(random_()) / 2147483648.0 - 1; }

  MarkingFeatures markings(const Stamp& stamp) {
    MarkingFeatures result{stamp, {}, {}};
    for (const double y : {5.25, 1.75, -1.75, -5.25}) {
      for (double x = 8; x < 100; x += 18) result.features.push_back(bar(x, y + 0.1 * noise()));
    }
    result.features.push_back(bar(60 + 60 * noise(), 12 * noise()));
    return result;
  }
  Feature bar(double x, double y) {
    Feature feature{x + noise(), y, 0.02 * noise(), 0.6};
    feature.covariance = Eigen::Vector3d(1, 0.04, 4e-4).asDiagonal();
    return feature;
  }

  static ObjectList vehicles(const Stamp& stamp, double seconds) {
    ObjectList result{stamp, {}};
    for (const double y : {3.5, -3.5}) {
      for (int ahead = 0; ahead < 4; ++ahead) {
        const double distance = 4 * seconds + 40 * ahead;
        TrackedObject object{0, 0, y, 0, 4};
        object.id = (static_cast<std::int64_t>(distance / 160) * 4 + ahead) * 2 + (y > 0 ? 1 : 0);
        object.x = std::fmod(distance, 160.0);
        object.movement = MovementState::moving;
        object.seen_by_radar = object.seen_by_camera = true;
        object.covariance = Eigen::Vector3d(0.2, 0.05, 1e-4).asDiagonal();
        result.objects.push_back(object);
      }
    }
    return result;
  }

  std::mt19937 random_{11};
};

constexpr int kTenMinutes = 15'000;  ///< ticks of the standing car

Rig standing_rig() {
  return {{{0, SensorKind::odometry, "bus", {}},
           {2, SensorKind::high_resolution_camera, "camera", {}},
           {3, SensorKind::object_fusion, "objects", {}}}};
}

/// False bars fill the road until each new one falls to an old one; from then on nothing grows.
TEST(BoundedMemory, AStandingCarsGraphFillsUpAndThenStays) {
  PerceptionConfig config;
  config.cycle_hz = 5;
  MultiLanePerception perception(config, standing_rig());
  GraphSizes graph;
  StandingCar car;
  for (int tick = 0; tick < kTenMinutes; ++tick) {
    for (const Measurement& measurement : car.tick(tick)) graph.feed(perception, measurement);
  }
  EXPECT_EQ(graph.cycles(), 2999U);
  EXPECT_EQ(graph.largest(0, 1).poses, 1U);
  EXPECT_LT(graph.largest(0, 1).features, 2000U);
  expect_no_growth(graph.largest(0.4, 0.7), graph.largest(0.7, 1));
  EXPECT_EQ(graph.last().status, EstimateStatus::ok) << "and the lanes are still there";
}

/// What is seen from one place again and again makes the road-level estimator neither surer than its sensors
/// nor less sure, and moves nothing.
TEST(BoundedMemory, AStandingCarsRoadStaysAsItIs) {
  PerceptionConfig config;
  config.cycle_hz = 5;
  config.estimator = EstimatorKind::road;
  MultiLanePerception perception(config, standing_rig());
  GraphSizes cycles;
  StandingCar car;
  LaneEstimate early;
  for (int tick = 0; tick < kTenMinutes; ++tick) {
    for (const Measurement& measurement : car.tick(tick)) cycles.feed(perception, measurement);
    if (tick == kTenMinutes / 5) early = cycles.last();
  }
  const LaneEstimate& late = cycles.last();
  EXPECT_EQ(late.status, EstimateStatus::ok);
  ASSERT_EQ(early.lanes.size(), 3U);
  ASSERT_EQ(late.lanes.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(late.lanes[i].id, early.lanes[i].id);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(lateral_at(late.boundaries[i], 20), 5.25 - 3.5 * static_cast<double>(i), 0.1);
    EXPECT_GT(sigma_at(late.boundaries[i], 60), 0.01);
  }
}

}  // namespace
}  // namespace lanefuse
