// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/lane_segmentation_source.hpp"

#include <iterator>
#include <numbers>
#include <utility>

#include "camera/ground_projection.hpp"
#include "camera/image_codec.hpp"
#include "camera/segmented_markings.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

LaneSegmentationSource::LaneSegmentationSource(const LaneSegmentationSourceConfig& config)
    : config_(config), network_(config.network) {}

CameraPose LaneSegmentationSource::pose_of(const SensorDescription& sensor) const {
  CameraPose pose;
  pose.mounting = sensor.mounting;
  const Eigen::Vector4d sigma(config_.height_sigma, config_.roll_sigma_deg * kDegree,
                              config_.pitch_sigma_deg * kDegree, config_.yaw_sigma_deg * kDegree);
  pose.covariance = sigma.cwiseAbs2().asDiagonal();
  return pose;
}

InputAccounting LaneSegmentationSource::add(const Measurement& measurement, const SourceContext& context) {
  const auto* image = std::get_if<CameraImage>(&measurement);
  if (!image) return {};
  const SensorDescription* sensor = context.rig.find(image->stamp.sensor_id);
  if (!sensor || !sensor->camera) return {.rejected = 1};
  auto camera = cameras_.find(sensor->id);
  if (camera == cameras_.end()) {
    camera = cameras_.emplace(sensor->id, Camera{CameraModel(*sensor->camera), ImageHealth()}).first;
  }
  const std::optional<Image> decoded = decode_image(image->bytes);
  // Frozen pictures are told apart where the car's motion is followed from image to image.
  if (camera->second.health.judge(*image, decoded, *sensor->camera, 0) != ImageFault::none) {
    return {.rejected = 1};
  }
  std::vector<ImageBar> runs = network_.find(decoded->view());
  FeatureSet set;
  set.source = Source::user;
  set.sensor_id = sensor->id;
  set.measured_at = image->stamp.measured_at;
  set.features =
      features_of_runs(runs, GroundProjection(camera->second.model, pose_of(*sensor)), config_.network);
  set.shared_error = SharedError{SharedError::Kind::pitch, config_.pitch_sigma_deg * kDegree};
  std::erase_if(set.features, [](const Feature& feature) { return !is_plausible(feature); });
  if (!set.features.empty()) pending_.push_back(std::move(set));
  return {.used = 1};
}

void LaneSegmentationSource::collect(Time, const SourceContext&, std::vector<FeatureSet>& sets) {
  std::move(pending_.begin(), pending_.end(), std::back_inserter(sets));
  pending_.clear();
}

void LaneSegmentationSource::reset() {
  cameras_.clear();
  pending_.clear();
}

}  // namespace lanefuse
