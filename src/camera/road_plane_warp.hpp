// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "camera/reduced_image.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// How the car moved from one image to the next, and how its camera nodded on the way.
struct PlaneMotion {
  enum Index : int { kForward, kLateral, kYaw, kPitchBefore, kPitchChange, kHeightChange, kRollChange };
  static constexpr int kSize = 7;
  /// [m] forward and to the left, in the vehicle frame before; [rad] counter-clockwise; [rad] the pitch
  /// before against the pose; [rad], [m], [rad] what pitch, height and roll changed by.
  Eigen::Matrix<double, kSize, 1> values = Eigen::Matrix<double, kSize, 1>::Zero();
};

/// Where the road that an image shows stood in the image before. Places in reduced pixels, at the corners of
/// square cells of the reduced image.
class RoadPlaneWarp {
 public:
  static constexpr int kCell = 8;  ///< [px] of the reduced image

  RoadPlaneWarp(const CameraModel& camera, const Reduction& reduction);

  [[nodiscard]] int columns() const { return columns_; }  ///< of cells
  [[nodiscard]] int rows() const { return rows_; }        ///< of cells

  struct Node {
    bool on_road = false;                              ///< in both images
    Eigen::Vector2f before = Eigen::Vector2f::Zero();  ///< [px] of the reduced image before
  };
  /// The corners of all cells, (columns + 1) x (rows + 1), row after row.
  [[nodiscard]] std::vector<Node> map(const CameraPose& pose, const PlaneMotion& motion) const;

  /// The road that the middle of a cell shows [m], in the vehicle frame; not on the road at and above the
  /// horizon.
  struct Place {
    bool on_road = false;
    double x = 0;
    double y = 0;
  };
  [[nodiscard]] std::vector<Place> cell_places(const CameraPose& pose) const;

  /// d before / d motion at the middle of each cell, by central differences; zero where there is no road.
  using Jacobian = Eigen::Matrix<double, 2, PlaneMotion::kSize>;
  [[nodiscard]] std::vector<Jacobian> jacobians(const CameraPose& pose, const PlaneMotion& motion) const;

 private:
  const CameraModel* camera_;
  Reduction reduction_;
  int columns_;
  int rows_;
  std::vector<Eigen::Vector2d> corner_directions_;
  std::vector<Eigen::Vector2d> cell_directions_;

  [[nodiscard]] std::vector<Node> map(const std::vector<Eigen::Vector2d>& directions, const CameraPose& pose,
                                      const PlaneMotion& motion) const;
};

}  // namespace lanefuse
