// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "drawing/graph_view.hpp"
#include "drawing/report.hpp"
#include "drawing/top_view.hpp"
#include "evaluation/ego_path.hpp"
#include "evaluation/exact_truth.hpp"
#include "support/road_scene.hpp"

/// A believable moment and drive for pictures: everything that a picture can show is in it.
namespace lanefuse::testing {

/// Scatter that is the same everywhere: roughly normal, of standard deviation one.
class Scatter {
 public:
  double operator()() {
    double sum = 0;
    for (int i = 0; i < 12; ++i) {
      state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
      sum += static_cast<double>(state_ >> 40) / 16777216.0;
    }
    return sum - 6;
  }

 private:
  std::uint64_t state_ = 5;
};

inline FusedFeature feature_on(const RoadScene& scene, int boundary, double x, Source source, double off) {
  FusedFeature fused;
  fused.feature.x = x;
  fused.feature.y = scene.boundary(boundary).y(x) + off;
  fused.feature.heading = scene.boundary(boundary).heading_at(x);
  fused.feature.source = source;
  fused.outlier = std::abs(off) > 0.55;
  fused.in_base_fit = !fused.outlier;
  return fused;
}

inline std::vector<FusedFeature> scattered_features(const RoadScene& scene) {
  Scatter scatter;
  std::vector<FusedFeature> features;
  for (double x = 4; x < 62; x += 4) {
    for (const int boundary : {1, 2})
      features.push_back(feature_on(scene, boundary, x, Source::serial_camera, 0.04 * scatter()));
  }
  for (double x = 9; x < 118; x += 3.1) {
    for (const int boundary : {0, 1, 2, 3}) {
      const double off = (0.05 + x / 900) * scatter() + (scatter() > 1.9 ? 1.0 : 0.0);
      features.push_back(feature_on(scene, boundary, x, Source::high_resolution_camera, off));
    }
  }
  for (double x = 30; x < 105; x += 5) {
    for (const int boundary : {1, 2})
      features.push_back(feature_on(scene, boundary, x, Source::objects, 0.2 * scatter()));
  }
  return features;
}

/// A vehicle that changes from the left lane into the middle one: two of its smoothing edges are off.
inline std::vector<SwitchState> lane_change(const RoadScene& scene) {
  std::vector<SwitchState> switches;
  for (const int side : {0, 1}) {
    Eigen::Vector2d last(40, scene.boundary(side).y(40));
    for (double x = 48; x < 105; x += 8) {
      const int boundary = x < 66 ? side : side + 1;
      const Eigen::Vector2d next(x, scene.boundary(boundary).y(x));
      const bool crosses = std::abs(next.y() - last.y()) > 2;
      switches.push_back({4, side == 0 ? Side::left : Side::right, last, next, crosses ? 0.0 : 0.97});
      last = next;
    }
  }
  return switches;
}

/// What an estimator that is a little wrong sees, with sigmas that grow ahead.
inline LaneEstimate believable_estimate(const RoadScene& scene, double wrong = 1) {
  LaneEstimate estimate = perfect_estimate(scene);
  for (std::size_t i = 0; i < estimate.boundaries.size(); ++i) {
    Boundary& boundary = estimate.boundaries[i];
    boundary.clothoid.lateral_offset += wrong * (i % 2 == 0 ? 0.05 : -0.03);
    boundary.clothoid.heading += 0.001 * wrong;
    boundary.clothoid.curvature += 4e-5 * wrong;
    boundary.covariance.diagonal() << 4e-3, 1e-6, 9e-10, 4e-14;
    boundary.range_end = i == 0 || i == 3 ? 96 : 118;
    sample_points(boundary);
  }
  return estimate;
}

inline TopView believable_view() {
  RoadScene scene;
  scene.course = {1.7, 0.005, 9e-4, -2e-6};
  TopView view;
  view.title = "12.5 s: the car ahead changes lane";
  view.estimate = believable_estimate(scene);
  view.debug.features = scattered_features(scene);
  view.debug.switches = lane_change(scene);
  view.debug.base_clothoid = scene.course;
  view.debug.base_clothoid->lateral_offset = 0;
  view.true_boundaries = boundaries_in_view(true_road(scene), scene.world_from_vehicle);
  for (const auto& [x, lane] : {std::pair{104.0, 1}, {38.0, 0}, {22.0, 2}}) {
    const double y = scene.boundary(lane).y(x) - kLaneWidth / 2;
    view.vehicles.push_back({lane, x, y, scene.boundary(lane).heading_at(x), 28, Eigen::Matrix3d::Identity(),
                             4.6, 1.8, MovementState::moving, 1, true, true});
  }
  return view;
}

inline EvaluationResult believable_exact_result() {
  RoadScene scene;
  const TrueRoad road = true_road(scene);
  ExactTruthEvaluation evaluation(road);
  Scatter scatter;
  for (int i = 0; i < 400; ++i) evaluation.add(believable_estimate(scene, 2 * scatter()), true_frame(scene));
  EvaluationResult result = evaluation.result();
  result.drive = {"simulated, seed 1, 2 km", "8c1f02ab", WitnessRule::radar_and_camera};
  return result;
}

/// A drive on a gentle arc; the estimate knows the curve roughly, and ends early where no vehicle is ahead.
inline EvaluationResult believable_path_result() {
  std::vector<TrueFrame> frames;
  for (int i = 0; i < 3000; ++i) {
    TrueFrame frame;
    frame.time = from_nanoseconds(20000000LL * i);
    frame.world_from_vehicle = constant_turn(30, 0.006, 0.02 * i);
    frames.push_back(frame);
  }
  EgoPathEvaluation evaluation(frames);
  Scatter scatter;
  for (int i = 0; i < 700; ++i) {
    RoadScene scene;
    scene.course = {kLaneWidth / 2 + 0.1 * scatter(), 0.002 * scatter(), 2e-4 + 6e-5 * scatter(), 0};
    LaneEstimate estimate = perfect_estimate(scene, i % 5 == 0 ? 45 : 125 + 15 * scatter());
    estimate.time = from_nanoseconds(80000000LL * i);
    estimate.yaw_rate = 0.006 + 0.006 * scatter();
    evaluation.add(estimate, i % 5 != 0 || i % 20 == 0);
  }
  EvaluationResult result = evaluation.result();
  result.drive = {"comma2k19, one minute", "", WitnessRule::radar_only};
  return result;
}

inline Report believable_report(EvaluationResult evaluation) {
  Report report;
  report.title = "Lanefuse: lanes by GraphSLAM fusion";
  report.evaluation = std::move(evaluation);
  report.run.duration_s = 66.7;
  report.run.inputs = InputAccounting{51234, 3, 12};
  report.run.largest_graph = GraphSize{113, 906, 12263};
  Scatter scatter;
  for (int i = 0; i < 800; ++i)
    report.run.cycle_ms.push_back(8 + 0.9 * scatter() + (i % 97 == 0 ? 4.0 : 0.0));
  report.moments.push_back(
      {believable_view(), "Two smoothing edges of the vehicle that changes lane are switched off."});
  return report;
}

inline GraphView lane_change_graph() {
  GraphView view;
  view.title = "A vehicle changes lane";
  for (int i = 0; i < 5; ++i) {
    view.nodes.push_back({8.0 * i, 0, "x" + std::to_string(i), "pose", 0.0});
    if (i > 0)
      view.edges.push_back(
          {static_cast<std::size_t>(3 * i - 3), static_cast<std::size_t>(3 * i), "odometry", false});
    for (const double side : {1.75, -1.75}) {
      view.nodes.push_back({8.0 * i + 30, (i < 3 ? 3.5 : 0) + side, "", "vehicle's feature", 0.0});
      const std::size_t node = view.nodes.size() - 1;
      view.edges.push_back({static_cast<std::size_t>(3 * i), node, "measurement", false});
      if (i > 0) view.edges.push_back({node - 3, node, "smoothing", i == 3});
    }
    view.edges.push_back({view.nodes.size() - 2, view.nodes.size() - 1, "width", false});
  }
  return view;
}

}  // namespace lanefuse::testing
