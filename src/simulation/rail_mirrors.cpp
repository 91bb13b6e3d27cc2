// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/rail_mirrors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanefuse {
namespace {

constexpr double kShortest = 2;  ///< [s] that a mirror stays, unless it leaves the field
constexpr double kLongest = 8;   ///< [s]

}  // namespace

RailMirrors::RailMirrors(const Range& a_scan, std::shared_ptr<const GuardRails> rails, Random random)
    : fewest_(static_cast<int>(a_scan.low)),
      most_(static_cast<int>(a_scan.high)),
      rails_(std::move(rails)),
      random_(random) {}

/// In the nearer of the two rails.
std::optional<SceneVehicle> RailMirrors::image_of(const Scene& scene, const SceneVehicle& vehicle) const {
  std::optional<SceneVehicle> nearest;
  double least = 0;
  for (const int side : {1, -1}) {
    const auto rail = rails_->beside(scene, {vehicle.station, vehicle.world_from_vehicle}, side);
    if (!rail) continue;
    const double distance = std::abs((rail->world_from_rail.inverse() * vehicle.world_from_vehicle).y);
    if (nearest && distance >= least) continue;
    least = distance;
    nearest = mirrored(vehicle, *rail);
  }
  return nearest;
}

/// Moves the mirrors on; drops those that are over, or no longer in the field.
void RailMirrors::renew(const Scene& scene, const RadarView& view) {
  std::vector<Mirror> kept;
  for (const Mirror& mirror : mirrors_) {
    const auto vehicle = std::ranges::find(scene.vehicles, mirror.vehicle, &SceneVehicle::id);
    if (vehicle == scene.vehicles.end() || mirror.until < scene.time) continue;
    const auto image = image_of(scene, *vehicle);
    if (!image || !view.sees(image->world_from_vehicle.position())) continue;
    kept.push_back({mirror.vehicle, mirror.until, *image});
  }
  mirrors_ = std::move(kept);
}

/// One more, of the vehicles that have none.
void RailMirrors::add(const Scene& scene, const RadarView& view) {
  std::vector<SceneVehicle> images;
  for (const SceneVehicle& vehicle : scene.vehicles) {
    if (std::ranges::find(mirrors_, vehicle.id, &Mirror::vehicle) != mirrors_.end()) continue;
    const auto image = image_of(scene, vehicle);
    if (image && view.sees(image->world_from_vehicle.position())) images.push_back(*image);
  }
  if (images.empty()) return;
  const auto chosen = static_cast<std::size_t>(random_.whole(0, static_cast<int>(images.size()) - 1));
  const Duration stay = from_seconds(random_.uniform(kShortest, kLongest));
  mirrors_.push_back({images[chosen].id, scene.time + stay, images[chosen]});
}

std::vector<SceneVehicle> RailMirrors::observe(const Scene& scene, const RadarView& view,
                                               const LineOfSight& sight) {
  renew(scene, view);
  for (auto before = mirrors_.size(); std::cmp_less(before, most_); ++before) {
    add(scene, view);
    if (mirrors_.size() == before) break;
  }
  const int count = random_.whole(fewest_, most_);
  std::vector<SceneVehicle> seen;
  for (const Mirror& mirror : mirrors_) {
    if (std::cmp_greater_equal(seen.size(), count)) break;
    const Eigen::Vector2d place = view.in_radar(mirror.image.world_from_vehicle.position());
    if (!sight.blocked(place, mirror.vehicle)) seen.push_back(mirror.image);
  }
  return seen;
}

}  // namespace lanefuse
