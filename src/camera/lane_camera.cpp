// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_camera.hpp"

#include <cassert>

#include "camera/ground_projection.hpp"
#include "camera/image_codec.hpp"
#include "camera/vehicle_regions.hpp"

namespace lanefuse {
namespace {

const CameraIntrinsics& lens_of(const SensorDescription& sensor) {
  assert(sensor.camera);
  return *sensor.camera;
}

bool tracks_the_lane(SensorKind kind) {
  return kind == SensorKind::serial_camera || kind == SensorKind::camera;
}

bool extracts_markings(SensorKind kind) {
  return kind == SensorKind::high_resolution_camera || kind == SensorKind::camera;
}

}  // namespace

LaneCamera::LaneCamera(const SensorDescription& sensor, const LaneCameraConfig& config)
    : sensor_(sensor),
      config_(config),
      model_(lens_of(sensor)),
      health_(config.health),
      vehicles_(lens_of(sensor), config.vehicles),
      tracker_(lens_of(sensor), config.tracker),
      markings_(lens_of(sensor), config.markings),
      calibration_(sensor.mounting, config.calibration) {}

CameraPose LaneCamera::pose_with(double pitch) const {
  CameraPose pose = calibration_.pose();
  pose.mounting.pitch += pitch;
  return pose;
}

LaneCamera::Seen LaneCamera::process(const CameraImage& image, const CameraMotion& motion,
                                     std::span<const TrackedObject> others) {
  const std::optional<Image> decoded = decode_image(image.bytes);
  const ImageFault fault = health_.judge(image, decoded, lens_of(sensor_), motion.distance_moved);
  if (fault == ImageFault::none) return process(decoded->view(), image.stamp, motion, others);
  view_ = {sensor_.id, image.stamp.measured_at, fault, calibration_.status(), pose_with(0), {}, {}, {}};
  return {};
}

LaneCamera::Seen LaneCamera::process(const ImageView& image, const Stamp& stamp, const CameraMotion& motion,
                                     std::span<const TrackedObject> others) {
  const double seconds = last_image_ ? to_seconds(stamp.measured_at - *last_image_) : 0;
  last_image_ = stamp.measured_at;
  view_ = {
      sensor_.id, stamp.measured_at, ImageFault::none, calibration_.status(), pose_with(last_pitch_), {}, {},
      {}};
  Seen seen;
  seen.boxes = find_vehicles(image, stamp, motion, seconds);
  hide_others(others);
  const LaneTrack& track = tracker_.track(
      {image, stamp.measured_at, calibration_.pose(), motion.speed, motion.yaw_rate, view_.vehicles});
  believe(track);
  calibration_.update(track, motion.speed, motion.yaw_rate, stamp.measured_at);
  view_.calibration = calibration_.status();
  view_.windows = track.windows;
  if (calibration_.status() == CalibrationStatus::bumped) {
    // What a camera believes that stands elsewhere than it thinks is worse than nothing.
    markings_.reset();
    return seen;
  }
  if (tracks_the_lane(sensor_.kind) && track.status == LaneTrackStatus::tracking) {
    seen.lane = serial_lane(track, stamp);
  }
  if (extracts_markings(sensor_.kind)) seen.markings = marking_features(image, stamp, motion);
  return seen;
}

CameraBoxes LaneCamera::find_vehicles(const ImageView& image, const Stamp& stamp, const CameraMotion& motion,
                                      double seconds) {
  CameraBoxes boxes{stamp, {}};
  if (!config_.detect_vehicles) return boxes;
  view_.vehicles = vehicles_.detect({image, view_.pose, motion.speed, motion.yaw_rate, seconds});
  for (const VehicleBox& box : view_.vehicles) {
    boxes.boxes.push_back({box.left, box.top, box.right, box.bottom, box.confidence});
  }
  return boxes;
}

/// What is known of vehicles from elsewhere hides the road, but is no witness of itself.
void LaneCamera::hide_others(std::span<const TrackedObject> others) {
  const GroundProjection projection(model_, view_.pose);
  for (const TrackedObject& object : others) {
    if (const auto box = vehicle_region(object, projection)) view_.vehicles.push_back(*box);
  }
}

/// The pitch and the bend of this very image: as the lane shows them, else as they are on average.
void LaneCamera::believe(const LaneTrack& track) {
  const bool tracked = track.status == LaneTrackStatus::tracking;
  last_pitch_ = tracked ? track.pitch : 0;
  const double sigma = tracked ? track.pitch_sigma : config_.body_pitch_sigma;
  view_.pose = pose_with(last_pitch_);
  view_.pose.covariance.row(2).setZero();
  view_.pose.covariance.col(2).setZero();
  view_.pose.covariance(2, 2) = sigma * sigma;
  // No image shows its own roll: the calibration knows the mean, and the body sways about it.
  const double sway = config_.calibration.body_roll_sigma;
  view_.pose.covariance(1, 1) += sway * sway;
  view_.pose.vertical_curvature = tracked ? track.vertical_curvature : 0;
  view_.pose.vertical_curvature_sigma =
      tracked ? track.vertical_curvature_sigma : config_.tracker.vertical_curvature_sigma;
}

SerialLane LaneCamera::serial_lane(const LaneTrack& track, const Stamp& stamp) const {
  SerialLane lane{stamp, track.left, track.right, {}};
  if (lane.left) lane.left->marking_width = track.left_marking_width;
  if (lane.right) lane.right->marking_width = track.right_marking_width;
  return lane;
}

MarkingFeatures LaneCamera::marking_features(const ImageView& image, const Stamp& stamp,
                                             const CameraMotion& motion) {
  MarkingFeatures markings{stamp, {}, {}};
  markings.features = markings_.extract({image, view_.pose, view_.vehicles, motion.distance_moved});
  markings.shared_error = markings_.shared_error();
  view_.bars = markings_.bars();
  return markings;
}

void LaneCamera::reset() {
  health_.reset();
  vehicles_.reset();
  tracker_.reset();
  markings_.reset();
  calibration_.reset();
  view_ = {};
  last_image_.reset();
  last_pitch_ = 0;
}

}  // namespace lanefuse
