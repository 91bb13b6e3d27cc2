// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "camera/image.hpp"
#include "sensors/camera_view.hpp"

namespace lanefuse {

/// What counts as paint, and where it is looked for.
struct MarkingExtractorConfig {
  double range_min = 6;          ///< [m] ahead of the vehicle frame's origin
  double range_max = 130;        ///< [m] [IROS16, sec. II-B]
  double lateral_max = 14;       ///< [m] to either side of the car, more where a bend leads there
  double width_min = 0.10;       ///< [m] of paint, on the ground
  double width_max = 0.30;       ///< [m]
  double width_tolerance = 0.3;  ///< share of the width by which paint may seem thinner or wider
  double row_spacing = 0.5;      ///< [m] between the rows looked at, where rows are denser on the road
  double feature_spacing = 1;    ///< [m] between the features of one line
  double radius_min = 400;       ///< [m] of the tightest bend
  double contrast_min = 6;       ///< [grey levels of 255] of paint against the road
  double contrast_to_noise = 4;  ///< least step at an edge over the row's own noise
  double noise_floor_px = 0.1;  ///< [px] what remains of a bar's error where noise is nil: ragged paint, lens
  double blur_px = 0.7;         ///< [px] sigma of lens and chip together
  double ragged_paint = 0.007;  ///< [m] by which the middle of real paint wanders
  bool learn_still = true;      ///< learn what never moves in the image (bonnet, reflections), and mask it
};

/// The paper's high-resolution marking features [IROS16, sec. II-B]: short pieces of paint anywhere on the
/// road, image by image, neither tracked nor modelled.
///
/// In each image row that tells something new about the road, bright (or yellow) bars whose width fits paint
/// are measured to a fraction of a pixel, linked with their neighbours, and believed where they run with the
/// road and with each other. What a bar's own noise and the camera's pose (CameraPose::covariance) do to its
/// place and heading is in its covariance. Works for any camera; nothing is allocated once warm.
class MarkingExtractor {
 public:
  /// Throws a configuration Error where the intrinsics are not sound (see CameraModel).
  explicit MarkingExtractor(const CameraIntrinsics& intrinsics, const MarkingExtractorConfig& config = {});
  ~MarkingExtractor();
  MarkingExtractor(MarkingExtractor&&) noexcept;
  MarkingExtractor& operator=(MarkingExtractor&&) noexcept;

  struct Input {
    ImageView image;  ///< blue, green, red or grey; of the camera's size, as the caller has checked
    const CameraPose& pose;
    std::span<const VehicleBox> vehicles;  ///< what they hide is not looked at
    double distance_moved = 0;             ///< [m] since the image before; 0 where unknown
  };

  /// Features in the vehicle frame of the image, near ones first. Valid until the next call.
  const std::vector<Feature>& extract(const Input& input);

  /// Every bar of the last image that was wide enough for paint, believed or not: for pictures.
  [[nodiscard]] const std::vector<ImageBar>& bars() const;

  /// What all features of the last image may have in common: the pitch of the camera. It is part of their
  /// covariances already.
  [[nodiscard]] SharedError shared_error() const;

  /// Forgets what never moved, as when the camera has been bumped.
  void reset();

 private:
  class Stages;
  std::unique_ptr<Stages> stages_;
};

}  // namespace lanefuse
