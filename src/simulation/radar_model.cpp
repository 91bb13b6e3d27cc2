// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/radar_model.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace lanefuse {
namespace {

constexpr double kLeastRange = 0.1;  ///< [m] that is ever measured
constexpr double kHeight = 0.5;      ///< [m] of the radars over the road
constexpr std::uint32_t kLongRangeId = 6;
constexpr std::uint32_t kFirstCornerId = 7;

struct Corner {
  const char* name;
  double x;    ///< [m]
  double y;    ///< [m]
  double yaw;  ///< [rad]
};
constexpr double kPi = std::numbers::pi;
constexpr std::array<Corner, kCorners> kCornerMountings{{{"front left", 0.7, 0.8, kPi / 4},
                                                         {"front right", 0.7, -0.8, -kPi / 4},
                                                         {"rear left", -3.5, 0.8, 3 * kPi / 4},
                                                         {"rear right", -3.5, -0.8, -3 * kPi / 4}}};

Random stream_of(const RadarModel::Setup& setup, std::uint64_t seed, const char* what) {
  return {seed, fmt::format("{}{}", setup.sensor.name, what)};
}

}  // namespace

RadarModel::RadarModel(const Setup& setup, std::uint64_t seed)
    : setup_(setup),
      random_(stream_of(setup, seed, "")),
      ghost_noise_(stream_of(setup, seed, ", noise of ghosts")),
      misalignment_(random_.normal(setup.radar.misalignment)),
      reflections_(stream_of(setup, seed, ", reflections")),
      ghost_reflections_(stream_of(setup, seed, ", reflections of ghosts")),
      clutter_(setup.radar.clutter, setup.rails, stream_of(setup, seed, ", clutter")),
      clutter_noise_(stream_of(setup, seed, ", noise of clutter")),
      mirrors_(setup.mirrors, setup.rails, stream_of(setup, seed, ", ghosts")) {}

RadarDetection RadarModel::with_errors(const RadarDetection& exact, Random& random) const {
  RadarDetection detection = exact;
  detection.range = std::max(kLeastRange, exact.range + random.normal(setup_.radar.sigma_range));
  detection.bearing = wrap_angle(exact.bearing + misalignment_ + random.normal(setup_.radar.sigma_azimuth));
  detection.range_rate += random.normal(setup_.radar.sigma_range_rate);
  return detection;
}

void RadarModel::see_vehicle(const SceneVehicle& vehicle, const RadarView& view, const LineOfSight& sight,
                             RadarScan& scan) {
  if (!random_.chance(setup_.radar.detection)) return;
  const Range& count = setup_.radar.reflections;
  for (int left = random_.whole(static_cast<int>(count.low), static_cast<int>(count.high)); left > 0;
       --left) {
    const Reflection reflection =
        reflections_.draw(vehicle, view.world_from_radar().position(), scan.stamp.measured_at);
    if (!view.sees(reflection.point) || sight.blocked(view.in_radar(reflection.point), vehicle.id)) continue;
    scan.detections.push_back(with_errors(view.measure(reflection), random_));
  }
}

void RadarModel::observe(const Scene& scene, std::vector<Measurement>& measurements) {
  const RadarView view(scene, setup_.sensor.mounting, setup_.radar);
  const LineOfSight sight(scene, view.world_from_radar());
  RadarScan scan{stamp(setup_.sensor, scene.time, setup_.radar.latency), {}};
  for (const SceneVehicle& vehicle : scene.vehicles) see_vehicle(vehicle, view, sight, scan);
  for (const RadarDetection& thing : clutter_.observe(scene, view)) {
    scan.detections.push_back(with_errors(thing, clutter_noise_));
  }
  for (const SceneVehicle& image : mirrors_.observe(scene, view, sight)) {
    const Reflection reflection =
        ghost_reflections_.draw(image, view.world_from_radar().position(), scene.time);
    if (view.sees(reflection.point)) {
      scan.detections.push_back(with_errors(view.measure(reflection), ghost_noise_));
    }
  }
  // By range, as radars do: their order must not tell what is what.
  std::ranges::stable_sort(scan.detections, {}, &RadarDetection::range);
  measurements.emplace_back(std::move(scan));
}

RadarModel::Setup long_range_radar_setup(const SensorPreset& preset,
                                         std::shared_ptr<const GuardRails> rails) {
  return {{kLongRangeId, SensorKind::long_range_radar, "long-range radar", {0.9, 0, kHeight, 0, 0, 0}},
          preset.long_range_radar,
          preset.ghosts.guard_rail_mirrors,
          std::move(rails)};
}

RadarModel::Setup short_range_radar_setup(const SensorPreset& preset, std::shared_ptr<const GuardRails> rails,
                                          int corner) {
  assert(corner >= 0 && corner < kCorners);
  const Corner& at = kCornerMountings[static_cast<std::size_t>(corner)];
  return {{kFirstCornerId + static_cast<std::uint32_t>(corner),
           SensorKind::short_range_radar,
           fmt::format("short-range radar, {}", at.name),
           {at.x, at.y, kHeight, 0, 0, at.yaw}},
          preset.short_range_radar,
          preset.ghosts.guard_rail_mirrors,
          std::move(rails)};
}

}  // namespace lanefuse
