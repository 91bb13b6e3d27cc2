// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/object_source.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lanefuse {
namespace {

/// How far the dead reckoning may be stretched to a stamp.
constexpr Duration kReach = std::chrono::milliseconds(100);

/// What is older than this says nothing any more.
constexpr Duration kOldest = std::chrono::milliseconds(500);

constexpr double kHalfTurn = 3.15;  ///< [rad] with some slack

/// Straight on at its speed, seen from where the car is now.
TrackedObject moved(TrackedObject object, double seconds, const Pose2& now_from_then) {
  const Pose2 then{object.x + object.speed * seconds * std::cos(object.heading),
                   object.y + object.speed * seconds * std::sin(object.heading), object.heading};
  const Pose2 now = now_from_then * then;
  object.x = now.x;
  object.y = now.y;
  object.heading = wrap_angle(now.heading);
  object.covariance = rotate_covariance(object.covariance, now_from_then.heading);
  return object;
}

/// Whether it was seen of late, as far as that is known: a track that is only carried on witnesses nothing.
bool is_fresh(const TrackedObject& object, Time now) {
  constexpr Duration kFresh = std::chrono::milliseconds(350);
  if (!object.last_radar && !object.last_camera) return true;
  const auto of_late = [&](const std::optional<Time>& seen) { return seen && now - *seen < kFresh; };
  // Near enough for the camera, it must be the camera's word of now, not of what the track once followed.
  constexpr double kCameraReach = 75;  // [m]
  constexpr Duration kLastWord = std::chrono::seconds(1);
  const bool outdated =
      object.last_camera && object.x < kCameraReach && now - *object.last_camera > kLastWord;
  return !outdated && (of_late(object.last_radar) || of_late(object.last_camera));
}

/// Bearings of more than half a turn: whoever sends them speaks of degrees.
bool is_turned_beyond(const RadarDetection& detection) {
  return std::isfinite(detection.bearing) && std::abs(detection.bearing) > kHalfTurn &&
         std::abs(detection.bearing) <= 180;
}
bool is_turned_beyond(const BoxDetection&) { return false; }

}  // namespace

InputAccounting ObjectSource::add(const Measurement& measurement, const SourceContext& context) {
  if (const auto* list = std::get_if<ObjectList>(&measurement)) return add_list(*list, context);
  if (const auto* scan = std::get_if<RadarScan>(&measurement)) {
    return add_look(maker_.make(*scan, context, look_), scan->detections, context);
  }
  if (const auto* boxes = std::get_if<CameraBoxes>(&measurement)) {
    return add_look(maker_.make(*boxes, context, look_), boxes->boxes, context);
  }
  return {};
}

template <typename Detection>
InputAccounting ObjectSource::add_look(bool made, const std::vector<Detection>& detections,
                                       const SourceContext& context) {
  const auto plausible = static_cast<std::size_t>(
      std::count_if(detections.begin(), detections.end(),
                    [](const Detection& detection) { return is_plausible(detection); }));
  const auto turned_beyond = static_cast<std::size_t>(
      std::count_if(detections.begin(), detections.end(),
                    [](const Detection& detection) { return is_turned_beyond(detection); }));
  if (made && !trust_.believe(look_, turned_beyond)) return {0, detections.size(), 0};
  const bool taken = made && follow(context);
  const std::size_t used = taken ? look_.sightings.size() : 0;
  return {used, detections.size() - plausible, plausible - used};
}

bool ObjectSource::follow(const SourceContext& context) {
  // The dead reckoning began anew, in another frame: what the tracker knows is nowhere in it.
  const MotionSample& first = context.motion.front();
  const bool anew = last_look_ && first.time > *last_look_ && first.odometry_from_vehicle == Pose2{};
  if (anew) {
    tracker_.reset();
    alignment_.lose_things();
  }
  alignment_.look(look_);
  alignment_.correct(look_);
  if (!tracker_.add(look_)) return false;
  last_look_ = std::max(last_look_.value_or(look_.measured_at), look_.measured_at);
  return true;
}

InputAccounting ObjectSource::add_list(const ObjectList& list, const SourceContext& context) {
  ObjectList good{list.stamp, {}};
  std::copy_if(list.objects.begin(), list.objects.end(), std::back_inserter(good.objects),
               [](const TrackedObject& object) { return is_plausible(object); });
  bear_witness(good.objects, list.stamp, context);
  const InputAccounting taken{good.objects.size(), list.objects.size() - good.objects.size(), 0};
  last_list_ = std::move(good);
  return taken;
}

void ObjectSource::bear_witness(std::span<const TrackedObject> objects, const Stamp& stamp,
                                const SourceContext& context) {
  FeatureSet set;
  set.source = Source::objects;
  set.sensor_id = stamp.sensor_id;
  set.measured_at = stamp.measured_at;
  set.lane_width = context.lane_width.value_or(config_.witness.default_width);
  for (const TrackedObject& object : objects) {
    if (is_witness(object, config_.witness)) {
      add_witness_features(object, *set.lane_width, config_.witness, set.features);
    }
  }
  pending_.push_back(std::move(set));
}

void ObjectSource::collect(Time now, const SourceContext& context, std::vector<FeatureSet>& sets) {
  objects_.clear();
  if (last_list_ && now - last_list_->stamp.measured_at < kOldest) {
    report_list(now, context);
  } else if (last_look_ && now - *last_look_ < kOldest) {
    report_tracks(now, context);
  }
  for (TrackedObject& object : objects_) {
    object.witness = is_witness(object, config_.witness) && is_fresh(object, now);
  }
  std::move(pending_.begin(), pending_.end(), std::back_inserter(sets));
  pending_.clear();
}

/// The tracks bear witness as of their last look: what came after it is for the fusion to say.
void ObjectSource::report_tracks(Time now, const SourceContext& context) {
  Pose2 then;
  if (!pose_at(context.motion, *last_look_, kReach, then)) return;
  if (last_look_ != last_witness_) {
    tracker_.write(*last_look_, then, then_);
    std::erase_if(then_, [&](const TrackedObject& object) { return !is_fresh(object, *last_look_); });
    bear_witness(then_, {*last_look_, *last_look_, 0}, context);
    last_witness_ = last_look_;
  }
  Pose2 odometry_from_vehicle;
  if (pose_at(context.motion, now, kReach, odometry_from_vehicle)) {
    tracker_.write(now, odometry_from_vehicle, objects_);
  }
}

void ObjectSource::report_list(Time now, const SourceContext& context) {
  if (context.motion.empty()) return;
  Pose2 then;
  Pose2 here;
  const Time measured_at = last_list_->stamp.measured_at;
  if (!pose_at(context.motion, measured_at, kReach, then) || !pose_at(context.motion, now, kReach, here))
    return;
  const Pose2 now_from_then = here.inverse() * then;
  for (const TrackedObject& object : last_list_->objects) {
    objects_.push_back(moved(object, to_seconds(now - measured_at), now_from_then));
  }
}

void ObjectSource::reset() {
  tracker_.reset();
  trust_.reset();
  alignment_.reset();
  last_list_.reset();
  last_look_.reset();
  last_witness_.reset();
  pending_.clear();
  objects_.clear();
}

}  // namespace lanefuse
