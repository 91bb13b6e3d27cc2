// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sensors/measurement.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace lanefuse {
namespace {

constexpr double kFarthest = 1000;           ///< [m] no sensor of a car sees so far
constexpr double kLargestTurn = 7;           ///< [rad] an angle, even if it has not been wrapped
constexpr double kSmallestVariance = 1e-12;  ///< a micrometre: what claims less would outvote everything else
constexpr double kLargestVariance = 1e6;     ///< a kilometre

bool is_within(double value, double bound) { return std::abs(value) < bound; }

bool is_bounded_and_symmetric(const auto& matrix) {
  return matrix.allFinite() && matrix.cwiseAbs().maxCoeff() < kLargestVariance &&
         matrix.isApprox(matrix.transpose(), 1e-6);
}

bool is_covariance(const Eigen::Matrix3d& matrix) {
  return is_bounded_and_symmetric(matrix) && matrix.diagonal().minCoeff() > kSmallestVariance &&
         matrix.llt().info() == Eigen::Success;
}

/// A clothoid's covariance may be singular: not every camera gives all four parameters.
bool is_semidefinite(const Eigen::Matrix4d& matrix) {
  if (!is_bounded_and_symmetric(matrix) || matrix.diagonal().minCoeff() < 0) return false;
  // Correlations, as the variances lie ten decades apart.
  Eigen::Vector4d scale = matrix.diagonal().cwiseSqrt();
  for (double& sigma : scale) sigma = sigma > 0 ? 1 / sigma : 1;
  const Eigen::Matrix4d correlation = scale.asDiagonal() * matrix * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(correlation, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() > -1e-6;
}

struct Plausibility {
  std::optional<std::string> operator()(const VehicleMotion& motion) const {
    if (motion.speed && !(std::abs(*motion.speed) < 150)) return "speed is not a car's";
    if (motion.yaw_rate && !(std::abs(*motion.yaw_rate) < 3)) return "yaw rate is not a car's";
    if (motion.wheel_speeds) {
      for (const double wheel : *motion.wheel_speeds) {
        if (!(std::abs(wheel) < 150)) return "wheel speed is not a car's";
      }
    }
    return {};
  }
  std::optional<std::string> operator()(const SerialLane& lane) const {
    if (lane.marking_width && !(*lane.marking_width > 0 && *lane.marking_width < 2))
      return "marking width is not one";
    return {};
  }
  std::optional<std::string> operator()(const MarkingFeatures& markings) const {
    if (markings.shared_error &&
        !(markings.shared_error->sigma >= 0 && markings.shared_error->sigma < kFarthest)) {
      return "shared error is not a sigma";
    };
    return {};
  }
  std::optional<std::string> operator()(const RadarScan&) const { return {}; }
  std::optional<std::string> operator()(const ObjectList&) const { return {}; }
  std::optional<std::string> operator()(const CameraImage&) const { return {}; }
  std::optional<std::string> operator()(const CameraBoxes&) const { return {}; }
  std::optional<std::string> operator()(const GnssInsFix& fix) const {
    const bool on_earth = std::abs(fix.latitude) <= std::numbers::pi / 2 &&
                          std::abs(fix.longitude) <= std::numbers::pi && is_within(fix.height, 1e5);
    if (!on_earth) return "position is not on Earth";
    if (!is_within(fix.heading, kLargestTurn)) return "heading is no angle";
    if (!is_covariance(fix.position_covariance)) return "covariance of the position is none";
    if (!(fix.heading_sigma > 0 && fix.heading_sigma < kLargestTurn)) return "heading's sigma is none";
    return {};
  }
};

}  // namespace

const char* to_string(FixKind kind) {
  switch (kind) {
    case FixKind::unknown:
      return "unknown";
    case FixKind::single:
      return "single";
    case FixKind::rtk_float:
      return "rtk_float";
    case FixKind::rtk_fixed:
      return "rtk_fixed";
  }
  return "?";
}

const Stamp& stamp_of(const Measurement& measurement) {
  return std::visit([](const auto& alternative) -> const Stamp& { return alternative.stamp; }, measurement);
}

std::optional<std::string> implausible(const Measurement& measurement) {
  const Stamp& stamp = stamp_of(measurement);
  if (stamp.received_at < stamp.measured_at) return "received before it was measured";
  return std::visit(Plausibility{}, measurement);
}

bool is_plausible(const Feature& feature) {
  return is_within(feature.x, kFarthest) && is_within(feature.y, kFarthest) &&
         is_within(feature.heading, kLargestTurn) && feature.confidence >= 0 && feature.confidence <= 1 &&
         is_covariance(feature.covariance);
}

bool is_plausible(const ClothoidMeasurement& measurement) {
  const Clothoid& clothoid = measurement.clothoid;
  const bool is_curve = is_within(clothoid.lateral_offset, kFarthest) &&
                        is_within(clothoid.heading, kLargestTurn) && is_within(clothoid.curvature, 1) &&
                        is_within(clothoid.curvature_rate, 1);
  return is_curve && is_semidefinite(measurement.covariance) &&
         is_within(measurement.range_begin, kFarthest) && is_within(measurement.range_end, kFarthest) &&
         measurement.range_end >= measurement.range_begin && measurement.confidence >= 0 &&
         measurement.confidence <= 1 &&
         (!measurement.marking_width || (*measurement.marking_width > 0 && *measurement.marking_width < 2));
}

bool is_plausible(const TrackedObject& object) {
  return is_within(object.x, kFarthest) && is_within(object.y, kFarthest) &&
         is_within(object.heading, kLargestTurn) && is_within(object.speed, 150) && object.existence >= 0 &&
         object.existence <= 1 && is_covariance(object.covariance);
}

bool is_plausible(const RadarDetection& detection) {
  return detection.range > 0 && detection.range < kFarthest && std::abs(detection.bearing) <= 3.15 &&
         is_within(detection.range_rate, 300);
}

bool is_plausible(const BoxDetection& box) {
  constexpr double kLargestImage = 65536;  // [px]
  return is_within(box.left, kLargestImage) && is_within(box.right, kLargestImage) &&
         is_within(box.top, kLargestImage) && is_within(box.bottom, kLargestImage) && box.left < box.right &&
         box.top < box.bottom && box.confidence >= 0 && box.confidence <= 1;
}

}  // namespace lanefuse
