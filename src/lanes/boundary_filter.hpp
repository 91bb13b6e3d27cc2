// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/clothoid.hpp"
#include "core/kalman.hpp"
#include "core/lane_estimate.hpp"
#include "core/pose2.hpp"
#include "lanes/lane_model_config.hpp"

namespace lanefuse {

/// One boundary's fit in one cycle: an offset of its own on the road's common course.
struct BoundaryFit {
  Clothoid clothoid;
  /// of (y0, theta0, c0, c1)
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
};

/// "A Kalman filter is used to filter each lane clothoid over time" [IROS16, sec. II-F]: state (y0, theta0,
/// c0, c1) in the vehicle frame, moved along with the car.
class BoundaryFilter {
 public:
  BoundaryFilter(std::uint64_t id, const BoundaryFit& first, const LaneModelConfig& config);

  /// Moves the boundary into the frame that the car has reached; a car that stands adds no doubt.
  /// The fitted c1 is an average over all that is seen, no local rate: it is carried, but drives neither
  /// curvature nor heading.
  void predict(const Pose2& old_from_new);

  void update(const BoundaryFit& fit);

  [[nodiscard]] std::uint64_t id() const { return id_; }
  [[nodiscard]] Clothoid clothoid() const { return Clothoid::from_vector(state_.mean); }
  [[nodiscard]] const Eigen::Matrix4d& covariance() const { return state_.covariance; }

  std::uint32_t misses = 0;  ///< cycles in a row without a feature
  double confidence = 0;     ///< of the boundary, from its features
  MarkingEvidence marking;

 private:
  std::uint64_t id_;
  const LaneModelConfig* config_;  ///< never null; a pointer, so that filters can be moved within a list
  Gaussian<4> state_;
};

}  // namespace lanefuse
