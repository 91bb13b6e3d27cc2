// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "camera/camera_model.hpp"
#include "camera/image_health.hpp"
#include "camera/lane_segmentation.hpp"
#include "sources/feature_source.hpp"

namespace lanefuse {

struct LaneSegmentationSourceConfig {
  bool enabled = false;
  LaneSegmentationConfig network;
  /// How well the camera's mounting in the rig holds in every image: this source learns nothing online.
  double height_sigma = 0.03;    ///< [m]
  double roll_sigma_deg = 0.3;   ///< [deg]
  double pitch_sigma_deg = 0.3;  ///< [deg]
  double yaw_sigma_deg = 0.3;    ///< [deg]
};

/// Marking features from the user's own lane-segmentation network, for every camera of the rig that hands
/// over images. One more source beside the paper's, under Source::user.
class LaneSegmentationSource final : public FeatureSource {
 public:
  /// Throws a configuration Error where the model cannot be loaded.
  explicit LaneSegmentationSource(const LaneSegmentationSourceConfig& config);

  /// An image counts as one item. Throws a configuration Error where the network does not fit the image.
  InputAccounting add(const Measurement& measurement, const SourceContext& context) override;
  void collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) override;
  void reset() override;

 private:
  struct Camera {
    CameraModel model;
    ImageHealth health;
  };

  LaneSegmentationSourceConfig config_;
  LaneSegmentation network_;
  std::map<std::uint32_t, Camera> cameras_;
  std::vector<FeatureSet> pending_;

  [[nodiscard]] CameraPose pose_of(const SensorDescription& sensor) const;
};

}  // namespace lanefuse
