// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "fusion/feature_fusion.hpp"
#include "support/window_view.hpp"

/// Drives the feature fusion by hand, a cycle at a time.
namespace lanefuse::testing {

inline constexpr Duration kCycle = std::chrono::milliseconds(40);

/// A feature at `pose` whose covariance stands in its own frame: 0.5 m along the marking, the rest as given.
inline Feature feature_at(const Pose2& pose, double across = 0.1, double heading_sigma = 0.01) {
  Feature feature{pose.x, pose.y, pose.heading, 0.6};
  const Eigen::Matrix3d own = Eigen::Vector3d(0.5, across, heading_sigma).cwiseAbs2().asDiagonal();
  feature.covariance = rotate_covariance(own, pose.heading);
  return feature;
}

/// The same for one side of a tracked thing.
inline Feature witnessed(std::int64_t track, Side side, const Pose2& pose, double across = 0.1) {
  Feature feature = feature_at(pose, across);
  feature.track_id = track;
  feature.side = side;
  feature.source = Source::objects;
  return feature;
}

class FusionDrive {
 public:
  explicit FusionDrive(const FusionConfig& config = {},
                       std::unique_ptr<WindowSolver> solver = std::make_unique<ConjugateGradientSolver>())
      : config_(config), fusion_(config_, std::move(solver)) {}
  FusionDrive(const FusionDrive&) = delete;
  FusionDrive& operator=(const FusionDrive&) = delete;

  /// The stamp of the coming cycle: sets are measured then unless they say otherwise.
  [[nodiscard]] Time coming() const { return now_ + kCycle; }

  [[nodiscard]] FeatureSet set(Source source, std::vector<Feature> features,
                               std::uint32_t sensor_id = 1) const {
    FeatureSet result;
    result.source = source;
    result.sensor_id = sensor_id;
    result.measured_at = coming();
    result.features = std::move(features);
    return result;
  }

  /// Runs the coming cycle with the car at this dead-reckoned pose.
  FusionResult step(const Pose2& odometry_from_vehicle, const std::vector<FeatureSet>& sets = {}) {
    now_ = coming();
    motion_.push_back({now_, odometry_from_vehicle, 0, 0});
    return fusion_.process({now_, motion_, sets}, [](Stage) {});
  }

  /// As after construction, but at a later time.
  void restart() {
    motion_.clear();
    fusion_.reset();
  }

  [[nodiscard]] const FeatureFusion& fusion() const { return fusion_; }
  [[nodiscard]] const SlidingWindow& window() const { return fusion_.window(); }
  [[nodiscard]] WindowView view() const { return WindowView(fusion_.window()); }

 private:
  FusionConfig config_;
  FeatureFusion fusion_;
  std::vector<MotionSample> motion_;
  Time now_ = from_nanoseconds(1'000'000'000);
};

/// A configuration whose every cycle is solved to the end.
inline FusionConfig thorough() {
  FusionConfig config;
  config.solver.max_iterations = 100;
  return config;
}

}  // namespace lanefuse::testing
