// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "camera/camera_model.hpp"
#include "camera/ground_projection.hpp"
#include "sensors/camera_view.hpp"
#include "simulation/scene.hpp"

namespace lanefuse {

/// Where a line of the road really crosses a row of an image.
struct TrueMarking {
  int line = 0;            ///< of the road
  double row = 0;          ///< [px]
  double left = 0;         ///< [px] column of the paint's left edge
  double column = 0;       ///< [px] of its centre
  double right = 0;        ///< [px] column of its right edge
  double station = 0;      ///< [m] along the road
  Eigen::Vector2d ground;  ///< [m] the centre in the vehicle frame
  bool painted = false;    ///< there is paint: no gap between dashes, not missing
  bool hidden = false;     ///< by a vehicle or a guard rail
  [[nodiscard]] bool visible() const { return painted && !hidden; }
};

/// Where everything really is in an image that CameraRenderer made of a scene: what image processing is
/// judged by. Exact but for paint's wear, which moves edges by a centimetre or two.
class ImageTruth {
 public:
  /// `scene` and `camera` must outlive it. `mounting` as in CameraRenderer::render.
  ImageTruth(const Scene& scene, const CameraModel& camera, const Mounting& mounting);

  /// The mounting, with the vertical curvature that comes nearest to the road's heights from 5 to 100 m.
  [[nodiscard]] const CameraPose& pose() const { return pose_; }

  /// The pixel of a place of the road, `height` [m] over it; nothing behind the camera. It may lie outside of
  /// the image.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel(double station, double lateral, double height = 0) const;

  /// Indices of the road's lines that run within 200 m ahead.
  [[nodiscard]] std::vector<int> lines() const;
  /// Where `line` crosses the row [px], between 2 and 200 m ahead, in or out of the image's sides; nothing
  /// where it does not.
  [[nodiscard]] std::optional<TrueMarking> marking(int line, double row) const;
  /// The same by place: the line at `station`.
  [[nodiscard]] std::optional<TrueMarking> marking_at(int line, double station) const;

  /// The vehicles that are in the image, nearest first, boxes around all that shows of them and cut at the
  /// image's borders; `confidence` is the share of the box that no nearer vehicle's box covers.
  [[nodiscard]] std::vector<VehicleBox> vehicles() const;

  /// Whether a vehicle or a guard rail stands between the camera and the road's surface there.
  [[nodiscard]] bool hidden(double station, double lateral) const;

 private:
  const Scene* scene_;
  const CameraModel* camera_;
  CameraPose pose_;
  GroundProjection flat_;  ///< without vertical curvature: heights come from the road

  [[nodiscard]] std::optional<VehicleBox> box_of(const SceneVehicle& vehicle) const;
  [[nodiscard]] bool behind_a_vehicle(const Eigen::Vector3d& point) const;
  [[nodiscard]] bool behind_a_rail(const Eigen::Vector3d& point, double station) const;
};

}  // namespace lanefuse
