// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sensors/measurement.hpp"

#include <cmath>

#include <Eigen/Cholesky>

namespace lanefuse {
namespace {

bool is_covariance(const auto& matrix) {
  if (!matrix.allFinite() || !matrix.isApprox(matrix.transpose(), 1e-6)) return false;
  return matrix.llt().info() == Eigen::Success;
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
    if (lane.marking_width && !(*lane.marking_width > 0 && *lane.marking_width < 2)) return "marking width is not one";
    return {};
  }
  std::optional<std::string> operator()(const MarkingFeatures& markings) const {
    if (markings.shared_error && !(markings.shared_error->sigma >= 0)) return "shared error is not a sigma";
    return {};
  }
  std::optional<std::string> operator()(const RadarScan&) const { return {}; }
  std::optional<std::string> operator()(const ObjectList&) const { return {}; }
};

}  // namespace

const Stamp& stamp_of(const Measurement& measurement) {
  return std::visit([](const auto& alternative) -> const Stamp& { return alternative.stamp; }, measurement);
}

std::optional<std::string> implausible(const Measurement& measurement) {
  const Stamp& stamp = stamp_of(measurement);
  if (stamp.received_at < stamp.measured_at) return "received before it was measured";
  return std::visit(Plausibility{}, measurement);
}

bool is_plausible(const Feature& feature) {
  const bool finite = std::isfinite(feature.x) && std::isfinite(feature.y) && std::isfinite(feature.heading);
  return finite && std::abs(feature.x) < 1000 && std::abs(feature.y) < 1000 && feature.confidence >= 0 &&
         feature.confidence <= 1 && is_covariance(feature.covariance);
}

bool is_plausible(const ClothoidMeasurement& measurement) {
  return measurement.clothoid.vector().allFinite() && is_covariance(measurement.covariance) &&
         std::isfinite(measurement.range_begin) && measurement.range_end >= measurement.range_begin &&
         measurement.range_end < 1000 && measurement.confidence >= 0 && measurement.confidence <= 1;
}

bool is_plausible(const TrackedObject& object) {
  const bool finite = std::isfinite(object.x) && std::isfinite(object.y) && std::isfinite(object.heading);
  return finite && std::abs(object.x) < 1000 && std::abs(object.y) < 1000 && std::abs(object.speed) < 150 &&
         object.existence >= 0 && object.existence <= 1 && is_covariance(object.covariance);
}

bool is_plausible(const RadarDetection& detection) {
  return detection.range > 0 && detection.range < 1000 && std::abs(detection.bearing) <= 3.15 &&
         std::abs(detection.range_rate) < 300;
}

}  // namespace lanefuse
