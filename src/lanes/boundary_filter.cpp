// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/boundary_filter.hpp"

#include <cmath>

namespace lanefuse {
namespace {

constexpr double kProcessStep = 2.4;  ///< [m] over which the configuration's process noise is given

Eigen::Matrix4d diagonal_from_sigmas(double offset, double heading, double curvature, double curvature_rate) {
  return Eigen::Vector4d(offset, heading, curvature, curvature_rate).cwiseAbs2().asDiagonal();
}

Eigen::Matrix4d measurement_noise(const LaneModelConfig& config, const BoundaryFit& fit) {
  return fit.covariance + diagonal_from_sigmas(config.measured_offset, config.measured_heading,
                                               config.measured_curvature, config.measured_curvature_rate);
}

}  // namespace

BoundaryFilter::BoundaryFilter(std::uint64_t id, const BoundaryFit& first, const LaneModelConfig& config)
    : id_(id), config_(&config), state_{first.clothoid.vector(), measurement_noise(config, first)} {}

void BoundaryFilter::predict(const Pose2& old_from_new) {
  const double dx = old_from_new.x;
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition(0, 1) = dx;
  transition(0, 2) = dx * dx / 2;
  transition(1, 2) = dx;
  const double steps = old_from_new.position().norm() / kProcessStep;
  const Eigen::Matrix4d noise =
      steps * diagonal_from_sigmas(config_->process_offset, config_->process_heading,
                                   config_->process_curvature, config_->process_curvature_rate);
  const double rate = state_.mean[3];
  state_.mean[3] = 0;
  const Clothoid moved = transform(clothoid(), old_from_new);
  lanefuse::predict<4>(state_, transition, noise);
  state_.mean = moved.vector();
  state_.mean[3] = rate;
}

void BoundaryFilter::update(const BoundaryFit& fit) {
  const Eigen::Vector4d residual = fit.clothoid.vector() - state_.mean;
  lanefuse::update<4, 4>(state_, residual, Eigen::Matrix4d::Identity(), measurement_noise(*config_, fit));
}

}  // namespace lanefuse
