// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/object_list_model.hpp"

#include <cmath>

namespace lanefuse {
namespace {

constexpr double kReachBehind = 50;              ///< [m] of the short-range radars, beside and behind
constexpr double kCameraField = 0.5;             ///< [rad] to either side
constexpr Duration kForgetAfter{1'000'000'000};  ///< a track that was not seen for so long is dropped
constexpr double kInLane = 0.9;  ///< [m] beside its lane's middle; who is further off is between two lanes

/// Says between which lines the vehicle drives. Where there is no road, nobody knows.
void put_labels(const Scene& scene, const SceneVehicle& vehicle, TrackedObject& object) {
  if (!scene.road) return;
  const std::optional<int> lane = scene.road->lane_around(vehicle.station, vehicle.lateral, kInLane);
  object.left_label = lane ? scene.road->line_label(scene.road->left_line(*lane)) : kNoLine;
  object.right_label = lane ? scene.road->line_label(scene.road->right_line(*lane)) : kNoLine;
}

}  // namespace

ObjectListModel::ObjectListModel(const SensorPreset& preset, std::uint64_t seed)
    : preset_(preset.object_list),
      radar_(preset.long_range_radar),
      camera_(preset.camera_boxes),
      noise_(preset.noise),
      random_(seed, "object list"),
      misalignment_(random_.normal(preset_.misalignment)) {}

SensorDescription ObjectListModel::description() const {
  return {4, SensorKind::object_fusion, "object list", {}};
}

ObjectListModel::Track ObjectListModel::make_track() {
  const double heading_sigma = random_.uniform(preset_.heading.low, preset_.heading.high);
  return {next_id_++, heading_sigma, Wander(radar_.sigma_range, preset_.tau, random_),
          Wander(1, preset_.tau, random_), Wander(1, preset_.tau, random_)};
}

void ObjectListModel::advance_tracks(Time now) {
  std::erase_if(tracks_, [&](const auto& entry) { return now - entry.second.last_seen > kForgetAfter; });
  for (auto& [vehicle, track] : tracks_) {
    track.x.advance(1 / preset_.hz, random_);
    track.y.advance(1 / preset_.hz, random_);
    track.heading.advance(1 / preset_.hz, random_);
  }
}

void ObjectListModel::verify(Track& track, const Pose2& ego_from_vehicle) {
  const double range = ego_from_vehicle.position().norm();
  const double bearing = std::atan2(ego_from_vehicle.y, ego_from_vehicle.x);
  if (range > camera_.range || std::abs(bearing) > kCameraField) return;
  const double fraction = range / camera_.range;
  const double detection =
      camera_.detection_near + fraction * (camera_.detection_at_90_m - camera_.detection_near);
  if (random_.chance(detection)) track.seen_by_camera = true;
}

TrackedObject ObjectListModel::describe(const Track& track, const SceneVehicle& vehicle,
                                        const Pose2& ego_from_vehicle) {
  const double sigma_y = preset_.sigma_y.at(ego_from_vehicle.position().norm());
  const Pose2 seen = Pose2{0, 0, misalignment_} * ego_from_vehicle;
  TrackedObject object;
  object.id = track.id;
  object.x = seen.x + track.x.value();
  object.y = seen.y + sigma_y * track.y.value();
  object.heading = wrap_angle(seen.heading + track.heading_sigma * track.heading.value());
  object.speed = vehicle.speed + random_.normal(radar_.sigma_range_rate);
  const Eigen::Vector3d sigma(radar_.sigma_range, sigma_y, track.heading_sigma);
  object.covariance = (sigma / noise_).array().square().matrix().asDiagonal();
  object.length = vehicle.front + vehicle.rear;
  object.width = vehicle.width;
  object.movement = MovementState::moving;
  object.seen_by_radar = true;
  object.seen_by_camera = track.seen_by_camera;
  return object;
}

void ObjectListModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  advance_tracks(scene.time);
  const LineOfSight sight(scene);
  const Pose2 ego_from_world = scene.ego.world_from_vehicle.inverse();
  ObjectList list;
  list.stamp = stamp(description(), scene.time, preset_.latency);
  for (const SceneVehicle& vehicle : scene.vehicles) {
    const Pose2 ego_from_vehicle = ego_from_world * vehicle.world_from_vehicle;
    const double range = ego_from_vehicle.position().norm();
    const bool in_reach = range < (ego_from_vehicle.x > 0 ? preset_.range_max : kReachBehind);
    if (!in_reach || sight.blocked(ego_from_vehicle.position(), vehicle.id)) continue;
    auto found = tracks_.find(vehicle.id);
    if (found == tracks_.end()) found = tracks_.emplace(vehicle.id, make_track()).first;
    Track& track = found->second;
    track.last_seen = scene.time;
    verify(track, ego_from_vehicle);
    list.objects.push_back(describe(track, vehicle, ego_from_vehicle));
    put_labels(scene, vehicle, list.objects.back());
  }
  measurements.emplace_back(std::move(list));
}

}  // namespace lanefuse
