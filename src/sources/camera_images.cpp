// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/camera_images.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

constexpr Duration kReach = std::chrono::milliseconds(200);  ///< of motion beyond its last sample
constexpr Duration kOldestObjects = std::chrono::milliseconds(300);

const MotionSample& sample_near(std::span<const MotionSample> motion, Time time) {
  const auto after = std::lower_bound(motion.begin(), motion.end(), time,
                                      [](const MotionSample& sample, Time t) { return sample.time < t; });
  return after == motion.end() ? motion.back() : *after;
}

double distance_between(std::span<const MotionSample> motion, Time from, Time to) {
  Pose2 first;
  Pose2 last;
  if (!pose_at(motion, from, kReach, first) || !pose_at(motion, to, kReach, last)) return 0;
  return std::hypot(last.x - first.x, last.y - first.y);
}

}  // namespace

CameraImages::Camera* CameraImages::camera_of(const CameraImage& image, const Rig& rig) {
  const SensorDescription* sensor = rig.find(image.stamp.sensor_id);
  if (!sensor || !sensor->camera) return nullptr;
  const auto known = cameras_.find(sensor->id);
  if (known != cameras_.end()) return &known->second;
  return &cameras_.emplace(sensor->id, Camera{LaneCamera(*sensor, config_.camera), {}}).first->second;
}

std::vector<TrackedObject> CameraImages::objects_at(Time time, double speed) const {
  if (!objects_ || time - objects_->stamp.measured_at > kOldestObjects ||
      objects_->stamp.measured_at - time > kOldestObjects) {
    return {};
  }
  const double seconds = to_seconds(time - objects_->stamp.measured_at);
  std::vector<TrackedObject> objects;
  for (TrackedObject object : objects_->objects) {
    if (!is_plausible(object)) continue;
    object.x += (object.speed * std::cos(object.heading) - speed) * seconds;
    object.y += object.speed * std::sin(object.heading) * seconds;
    objects.push_back(object);
  }
  return objects;
}

InputAccounting CameraImages::take(const CameraImage& image, const SourceContext& context,
                                   std::vector<Measurement>& seen) {
  if (!config_.enabled || context.motion.empty()) return {.dropped = 1};
  Camera* camera = camera_of(image, context.rig);
  if (!camera) {
    views_.push_back({image.stamp.sensor_id, image.stamp.measured_at, ImageFault::empty, {}, {}, {}, {}, {}});
    return {.rejected = 1};
  }
  const Time time = image.stamp.measured_at;
  if (camera->last_image && time <= *camera->last_image) return {.dropped = 1};
  const MotionSample& sample = sample_near(context.motion, time);
  CameraMotion motion{sample.speed, sample.yaw_rate, 0};
  if (camera->last_image) motion.distance_moved = distance_between(context.motion, *camera->last_image, time);
  camera->last_image = time;
  LaneCamera::Seen what = camera->lane_camera.process(image, motion, objects_at(time, sample.speed));
  views_.push_back(camera->lane_camera.view());
  if (what.lane) seen.emplace_back(std::move(*what.lane));
  if (what.markings) seen.emplace_back(std::move(*what.markings));
  if (!what.boxes.boxes.empty()) seen.emplace_back(std::move(what.boxes));
  switch (views_.back().fault) {
    case ImageFault::none:
      return {.used = 1};
    case ImageFault::too_dark:
    case ImageFault::overexposed:
      return {.dropped = 1};  // nothing is wrong with the camera
    default:
      return {.rejected = 1};
  }
}

void CameraImages::reset() {
  cameras_.clear();
  objects_.reset();
  views_.clear();
}

}  // namespace lanefuse
