// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/line_of_sight.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lanefuse {

LineOfSight::LineOfSight(const Scene& scene, const Pose2& world_from_sensor) {
  const Pose2 sensor_from_world = world_from_sensor.inverse();
  for (const SceneVehicle& vehicle : scene.vehicles) {
    const Pose2 sensor_from_vehicle = sensor_from_world * vehicle.world_from_vehicle;
    const Eigen::Vector2d middle =
        sensor_from_vehicle * Eigen::Vector2d((vehicle.front - vehicle.rear) / 2, 0);
    const double straight_on = std::atan2(middle.y(), middle.x());
    Shadow shadow{vehicle.id, straight_on, straight_on, middle.norm()};
    for (const double x : {-vehicle.rear, vehicle.front}) {
      for (const double y : {-vehicle.width / 2, vehicle.width / 2}) {
        const Eigen::Vector2d corner = sensor_from_vehicle * Eigen::Vector2d(x, y);
        const double bearing = straight_on + wrap_angle(std::atan2(corner.y(), corner.x()) - straight_on);
        shadow.from = std::min(shadow.from, bearing);
        shadow.to = std::max(shadow.to, bearing);
        shadow.range = std::min(shadow.range, corner.norm());
      }
    }
    shadows_.push_back(shadow);
  }
}

bool LineOfSight::blocked(const Eigen::Vector2d& point, std::int64_t except) const {
  const double range = point.norm();
  const double bearing = std::atan2(point.y(), point.x());
  return std::any_of(shadows_.begin(), shadows_.end(), [&](const Shadow& shadow) {
    const double middle = (shadow.from + shadow.to) / 2;
    const double half = (shadow.to - shadow.from) / 2;
    return shadow.id != except && range > shadow.range && std::abs(wrap_angle(bearing - middle)) < half;
  });
}

double LineOfSight::hidden_share(std::int64_t vehicle) const {
  const auto own = std::ranges::find(shadows_, vehicle, &Shadow::id);
  if (own == shadows_.end()) return 1;
  const double width = own->to - own->from;
  std::vector<std::pair<double, double>> covers;  // bearings, counted from the vehicle's first
  for (const Shadow& shadow : shadows_) {
    if (shadow.id == vehicle || shadow.range >= own->range) continue;
    const double middle = wrap_angle((shadow.from + shadow.to) / 2 - (own->from + own->to) / 2) + width / 2;
    const double half = (shadow.to - shadow.from) / 2;
    covers.emplace_back(std::max(0.0, middle - half), std::min(width, middle + half));
  }
  std::ranges::sort(covers);
  double hidden = 0, reached = 0;
  for (const auto& [from, to] : covers) {
    hidden += std::max(0.0, to - std::max(from, reached));
    reached = std::max(reached, to);
  }
  return hidden / width;
}

}  // namespace lanefuse
