// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/fusion_drive.hpp"

namespace lanefuse {
namespace {

using testing::EdgeKind;
using testing::FusionDrive;
using testing::WindowView;

/// A solver that knows the car's own path exactly: it holds all poses and moves the features alone.
class ExactOdometrySolver final : public GraphSolver {
 public:
  SolveResult solve(PoseGraph& graph, const SolverConfig& config) override {
    for (Vertex& vertex : graph.vertices) vertex.fixed = vertex.role == VertexRole::pose;
    const SolveResult result = solver_->solve(graph, config);
    bool newest = true;
    for (auto vertex = graph.vertices.rbegin(); vertex != graph.vertices.rend(); ++vertex) {
      if (vertex->role == VertexRole::pose) vertex->fixed = std::exchange(newest, false);
    }
    return result;
  }

 private:
  std::unique_ptr<GraphSolver> solver_ = make_schur_solver();
};

/// Other vehicles in the world, by cycle: what they do does not depend on us.
struct Traffic {
  struct Vehicle {
    std::vector<double> lateral;  ///< [m] y of the vehicle in each cycle
    double start = 0;             ///< [m] x in the first one
    double step = 0;              ///< [m] driven a cycle
    double heading = 0;           ///< [rad]
  };
  std::vector<Vehicle> vehicles;

  [[nodiscard]] FeatureSet seen_from(const Pose2& car, std::size_t cycle, const FusionDrive& drive) const {
    FeatureSet set = drive.set(Source::objects, {});
    set.lane_width = LaneWidth{3.6, 0.1};  // not quite what the features were made with: the width edges pull
    for (std::size_t v = 0; v < vehicles.size(); ++v) {
      const double x = vehicles[v].start + vehicles[v].step * static_cast<double>(cycle);
      const double y = vehicles[v].lateral[cycle];
      const double heading = vehicles[v].heading;
      const auto id = static_cast<std::int64_t>(v);
      set.features.push_back(
          testing::witnessed(id, Side::left, car.inverse() * Pose2{x, y + 1.75, heading}, 0.3));
      set.features.push_back(
          testing::witnessed(id, Side::right, car.inverse() * Pose2{x, y - 1.75, heading}, 0.3));
    }
    return set;
  }
};

constexpr std::size_t kCycles = 25;

/// Vehicles that sway in their lanes, and some of which change lane at once or in a few cycles.
Traffic any_traffic() {
  Traffic traffic;
  const int count = *rc::gen::inRange(1, 4);
  for (int v = 0; v < count; ++v) {
    Traffic::Vehicle vehicle;
    // Off the grid of the steps, so that no feature lies just as near to two others, nor just on a gate.
    vehicle.start = 15 + 12.0123 * v * v + *rc::gen::inRange(0, 50) * 0.1;
    vehicle.step = *rc::gen::inRange(10, 40) * 0.1;
    vehicle.heading = *rc::gen::inRange(-20, 21) * 1e-3;
    const int change_at = *rc::gen::inRange(2, 40);
    const double change_step = *rc::gen::inRange(-10, 11) * 0.1;
    double y = 3.5 * *rc::gen::inRange(-1, 2);
    for (std::size_t cycle = 0; cycle < kCycles; ++cycle) {
      const int since = static_cast<int>(cycle) - change_at;
      if (since >= 0 && since < 3) y += change_step;
      vehicle.lateral.push_back(y + *rc::gen::inRange(-20, 21) * 0.01);
    }
    traffic.vehicles.push_back(vehicle);
  }
  return traffic;
}

/// Our car: straight on, or over to a lane beside in the course of the drive.
Pose2 car_at(std::size_t cycle, double lane_change) {
  const double x = 1.2 * static_cast<double>(cycle);
  const double phase = std::numbers::pi * x / (1.2 * kCycles);
  const double slope = lane_change / 2 * std::sin(phase) * std::numbers::pi / (1.2 * kCycles);
  return {x, lane_change / 2 * (1 - std::cos(phase)), std::atan(slope)};
}

void follow(FusionDrive& drive, const Traffic& traffic, double lane_change) {
  for (std::size_t cycle = 0; cycle < kCycles; ++cycle) {
    const Pose2 car = car_at(cycle, lane_change);
    drive.step(car, {traffic.seen_from(car, cycle, drive)});
  }
}

FusionConfig exact_config() {
  FusionConfig config = testing::thorough();
  config.keyframe_distance = 0.5;  // every cycle, whatever the way
  config.drop_behind = 500;        // forgetting is no matter of this test
  config.association = {.along = 1.2345, .across = 0.6123, .across_per_metre = 0};  // as wide from every lane
  return config;
}

RC_GTEST_PROP(EgoLaneChange, LeavesWidthAndSmoothingErrorsAsTheyWere, ()) {
  const Traffic traffic = any_traffic();
  const double lane_change = *rc::gen::element(-3.5, 3.5);
  const auto solver = [] { return make_window_solver(std::make_unique<ExactOdometrySolver>()); };
  FusionDrive straight(exact_config(), solver());
  FusionDrive changing(exact_config(), solver());
  follow(straight, traffic, 0);
  follow(changing, traffic, lane_change);
  const WindowView one = straight.view();
  const WindowView other = changing.view();
  for (const EdgeKind kind : {EdgeKind::width, EdgeKind::smoothing}) {
    const auto edges = one.edges_of(kind);
    RC_ASSERT(edges == other.edges_of(kind));
    RC_ASSERT(!edges.empty());
    for (const std::size_t i : edges) {
      RC_ASSERT((one.error_of(i) - other.error_of(i)).cwiseAbs().maxCoeff() < 1e-6);
      RC_ASSERT(std::abs(one.switch_of(i) - other.switch_of(i)) < 1e-6);
    }
  }
}

/// With odometry edges as they are: where the others keep their lanes, our own lane change makes no error at
/// all.
TEST(EgoLaneChange, PullsAtNoWitnessThatKeepsItsLane) {
  Traffic traffic;
  traffic.vehicles.push_back({std::vector<double>(kCycles, 3.5), 30, 1.5});
  traffic.vehicles.push_back({std::vector<double>(kCycles, -3.5), 20, 2.5});
  FusionDrive drive;
  for (std::size_t cycle = 0; cycle < kCycles; ++cycle) {
    const Pose2 car = car_at(cycle, 3.5);
    FeatureSet set = traffic.seen_from(car, cycle, drive);
    set.lane_width->mean = 3.5;
    drive.step(car, {set});
  }
  const WindowView view = drive.view();
  for (const EdgeKind kind : {EdgeKind::width, EdgeKind::smoothing}) {
    for (const std::size_t i : view.edges_of(kind)) {
      EXPECT_LT(view.error_of(i).tail<2>().norm(), 1e-6);  // along the road nothing is said
      EXPECT_NEAR(view.switch_of(i), 1, 1e-6);
    }
  }
}

}  // namespace
}  // namespace lanefuse
