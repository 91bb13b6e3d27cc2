// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include "support/fusion_drive.hpp"

/// The two examples that [IROS16] explains its graph with, for tests and for the pictures in docs/.
namespace lanefuse::testing {

inline constexpr double kLaneWidthOfScene = 3.5;

/// The two features of a tracked vehicle in the middle of its lane, as the object source makes them.
inline std::vector<Feature> vehicle_features(double x, double y) {
  const double half = kLaneWidthOfScene / 2;
  return {witnessed(7, Side::left, {x, y + half, 0}, 0.3), witnessed(7, Side::right, {x, y - half, 0}, 0.3)};
}

inline FeatureSet vehicle_set(const FusionDrive& drive, double x, double y) {
  FeatureSet set = drive.set(Source::objects, vehicle_features(x, y), 3);
  set.lane_width = LaneWidth{kLaneWidthOfScene, 0.1};
  return set;
}

/// A serial camera's piece of a straight marking.
inline FeatureSet serial_set(const FusionDrive& drive, double y, double from, double to) {
  FeatureSet set = drive.set(Source::serial_camera, {}, 1);
  ClothoidMeasurement marking;
  marking.clothoid.lateral_offset = y;
  marking.covariance = Eigen::Vector4d(0.05, 2e-3, 1e-5, 1e-7).cwiseAbs2().asDiagonal();
  marking.range_begin = from;
  marking.range_end = to;
  set.clothoids.push_back(marking);
  return set;
}

/// Fig. "A GraphSLAM example": one vehicle, measured at t-1 and t; a marking feature f* that the serial
/// camera saw at t-1 and the high-resolution camera at t.
inline std::unique_ptr<FusionDrive> graph_slam_example() {
  FusionConfig config = thorough();
  config.keyframe_distance = 8;
  auto drive = std::make_unique<FusionDrive>(config);
  drive->step({0, 0, 0}, {serial_set(*drive, -1.75, 19, 19), vehicle_set(*drive, 14, 3.6)});
  drive->step({8, 0, 0}, {drive->set(Source::high_resolution_camera, {feature_at({11.2, -1.8, 0.002})}, 2),
                          vehicle_set(*drive, 14, 3.6)});
  return drive;
}

/// Fig. "graphslamfusion": a vehicle drives in the left lane, not quite in its middle, and is then in the
/// right one. It is seen now and then, as between other cars, so that two sightings stand on the two sides of
/// the change.
struct LaneChangeScene {
  bool width_edges = false;
  bool smoothing_edges = false;

  static constexpr double kStep = 12;   ///< [m] that both cars drive between sightings
  static constexpr double kAhead = 30;  ///< [m] from our car to the other
  static constexpr std::array kOffsets{3.85, 3.87, 3.82, 3.60, 3.20, 0.65, 0.42, 0.33, 0.30};  ///< [m] its y
  static constexpr int kBefore = 5;  ///< sightings in the left lane

  /// The markings of the right lane, where cameras see them at the vehicle's place.
  [[nodiscard]] std::unique_ptr<FusionDrive> run() const {
    FusionConfig config = thorough();
    config.width_edges = width_edges;
    config.smoothing_edges = smoothing_edges;
    config.drop_behind = 500;  // the picture holds the whole manoeuvre
    auto drive = std::make_unique<FusionDrive>(config);
    for (std::size_t i = 0; i < kOffsets.size(); ++i) {
      drive->step({kStep * static_cast<double>(i), 0, 0},
                  {serial_set(*drive, 1.75, kAhead, kAhead), serial_set(*drive, -1.75, kAhead, kAhead),
                   drive->set(Source::high_resolution_camera,
                              {feature_at({kAhead, 1.77, 0}), feature_at({kAhead, -1.73, 0})}, 2),
                   vehicle_set(*drive, kAhead, kOffsets[i])});
    }
    return drive;
  }
};

/// The features that one sighting of the vehicle gave: vertices of a WindowView.
struct Sighting {
  VertexId keyframe = 0;
  VertexId left = 0;
  VertexId right = 0;
};

/// From old to new.
inline std::vector<Sighting> sightings(const WindowView& view) {
  std::vector<Sighting> result;
  for (const std::size_t i : view.edges_of(EdgeKind::measurement)) {
    if (view.origin(i).source != Source::objects) continue;
    const Edge& edge = view.edge(i);
    const auto same = std::find_if(result.begin(), result.end(),
                                   [&](const Sighting& s) { return s.keyframe == edge.from; });
    Sighting& sighting = same == result.end() ? result.emplace_back(Sighting{edge.from, 0, 0}) : *same;
    (view.feature(edge.to).side == Side::left ? sighting.left : sighting.right) = edge.to;
  }
  std::sort(result.begin(), result.end(),
            [](const Sighting& a, const Sighting& b) { return a.keyframe < b.keyframe; });
  return result;
}

/// The distance of a sighting's two features across the road.
inline double width_of(const WindowView& view, const Sighting& sighting) {
  return (view.vertex(sighting.left).pose.inverse() * view.vertex(sighting.right).pose).position().norm();
}

}  // namespace lanefuse::testing
