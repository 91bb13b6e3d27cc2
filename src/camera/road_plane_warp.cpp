// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/road_plane_warp.hpp"

#include <cmath>

#include "camera/ground_projection.hpp"

namespace lanefuse {
namespace {

CameraPose changed(CameraPose pose, double pitch, double height, double roll) {
  pose.mounting.pitch += pitch;
  pose.mounting.z += height;
  pose.mounting.roll += roll;
  return pose;
}

}  // namespace

RoadPlaneWarp::RoadPlaneWarp(const CameraModel& camera, const Reduction& reduction)
    : camera_(&camera),
      reduction_(reduction),
      columns_(reduction.width / kCell),
      rows_(reduction.height / kCell) {
  const auto direction = [&](double column, double row) {
    return camera.direction({reduction.full_column(column), reduction.full_row(row)});
  };
  for (int v = 0; v <= rows_; ++v) {
    for (int u = 0; u <= columns_; ++u) corner_directions_.push_back(direction(u * kCell, v * kCell));
  }
  constexpr double kMiddle = 0.5 * (kCell - 1);
  for (int v = 0; v < rows_; ++v) {
    for (int u = 0; u < columns_; ++u) {
      cell_directions_.push_back(direction(u * kCell + kMiddle, v * kCell + kMiddle));
    }
  }
}

std::vector<RoadPlaneWarp::Node> RoadPlaneWarp::map(const CameraPose& pose, const PlaneMotion& motion) const {
  return map(corner_directions_, pose, motion);
}

std::vector<RoadPlaneWarp::Node> RoadPlaneWarp::map(const std::vector<Eigen::Vector2d>& directions,
                                                    const CameraPose& pose, const PlaneMotion& motion) const {
  const auto& m = motion.values;
  const double pitch = m[PlaneMotion::kPitchBefore];
  const GroundProjection before(*camera_, changed(pose, pitch, 0, 0));
  const GroundProjection now(*camera_, changed(pose, pitch + m[PlaneMotion::kPitchChange],
                                               m[PlaneMotion::kHeightChange], m[PlaneMotion::kRollChange]));
  const double cosine = std::cos(m[PlaneMotion::kYaw]);
  const double sine = std::sin(m[PlaneMotion::kYaw]);
  std::vector<Node> nodes(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto ground = now.ground_of_direction(directions[i]);
    if (!ground) continue;
    const Eigen::Vector2d there(cosine * ground->x() - sine * ground->y() + m[PlaneMotion::kForward],
                                sine * ground->x() + cosine * ground->y() + m[PlaneMotion::kLateral]);
    const auto pixel = before.pixel(there);
    if (!pixel) continue;
    nodes[i] = {true,
                Eigen::Vector2d(reduction_.column(pixel->x()), reduction_.row(pixel->y())).cast<float>()};
  }
  return nodes;
}

std::vector<RoadPlaneWarp::Place> RoadPlaneWarp::cell_places(const CameraPose& pose) const {
  const GroundProjection projection(*camera_, pose);
  std::vector<Place> places(cell_directions_.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto ground = projection.ground_of_direction(cell_directions_[i]);
    if (ground) places[i] = {true, ground->x(), ground->y()};
  }
  return places;
}

std::vector<RoadPlaneWarp::Jacobian> RoadPlaneWarp::jacobians(const CameraPose& pose,
                                                              const PlaneMotion& motion) const {
  constexpr double kStep = 1e-3;  // [m] and [rad]
  std::vector<Jacobian> jacobians(cell_directions_.size(), Jacobian::Zero());
  for (int p = 0; p < PlaneMotion::kSize; ++p) {
    PlaneMotion more = motion;
    PlaneMotion less = motion;
    more.values[p] += kStep;
    less.values[p] -= kStep;
    const std::vector<Node> a = map(cell_directions_, pose, more);
    const std::vector<Node> b = map(cell_directions_, pose, less);
    for (std::size_t i = 0; i < jacobians.size(); ++i) {
      if (!a[i].on_road || !b[i].on_road) continue;
      jacobians[i].col(p) = (a[i].before - b[i].before).cast<double>() / (2 * kStep);
    }
  }
  return jacobians;
}

}  // namespace lanefuse
