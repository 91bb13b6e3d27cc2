// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "camera/lane_camera.hpp"
#include "sensors/camera_view.hpp"
#include "sources/feature_source.hpp"

namespace lanefuse {

struct CameraImagesConfig {
  bool enabled = true;
  LaneCameraConfig camera;  ///< the same for all cameras of the rig
};

/// Turns cameras' images into what smart cameras send; from there on nobody knows the difference.
class CameraImages {
 public:
  explicit CameraImages(const CameraImagesConfig& config) : config_(config) {}

  /// Appends to `seen` what the image shows. An image counts as one item: rejected where it is
  /// damaged, dropped where it is too dark or too bright (views() says so), where there is no motion yet, and
  /// where images are not used.
  InputAccounting take(const CameraImage& image, const SourceContext& context,
                       std::vector<Measurement>& seen);

  /// Other vehicles as some fusion tracks them: they hide the road in the images that follow.
  void note(const ObjectList& objects) { objects_ = objects; }

  /// What was seen since forget_views(), image by image.
  [[nodiscard]] std::span<const CameraView> views() const { return views_; }
  void forget_views() { views_.clear(); }

  void reset();

 private:
  struct Camera {
    LaneCamera lane_camera;
    std::optional<Time> last_image;
  };

  CameraImagesConfig config_;
  std::map<std::uint32_t, Camera> cameras_;
  std::optional<ObjectList> objects_;
  std::vector<CameraView> views_;

  Camera* camera_of(const CameraImage& image, const Rig& rig);
  [[nodiscard]] std::vector<TrackedObject> objects_at(Time time, double speed) const;
};

}  // namespace lanefuse
