// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "objects/track_sight.hpp"

#include <algorithm>
#include <cmath>

#include "core/pose2.hpp"

namespace lanefuse {

void TrackSight::look(const SightingSet& look, std::span<const ObjectTrack> tracks) {
  constexpr double kEdge = 0.96;  // of a field: what lies at its edge may as well be outside
  const Pose2 sensor_from_odometry = look.odometry_from_sensor.inverse();
  views_.resize(tracks.size());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Eigen::Vector2d at = sensor_from_odometry * tracks[i].position();
    View& view = views_[i];
    view.range = std::max(1.0, at.norm());
    view.bearing = std::atan2(at.y(), at.x());
    view.half_angle = std::atan2(tracks[i].width / 2, view.range);
    const bool inside = look.field.contains(view.range / kEdge, view.bearing / kEdge);
    view.detection = inside ? look.field.detection_at(view.range) : 0;
  }
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (views_[i].detection > 0 && hidden(i, tracks)) views_[i].detection = 0;
  }
}

bool TrackSight::hidden(std::size_t track, std::span<const ObjectTrack> tracks) const {
  constexpr double kNearer = 3;  // [m]
  const View& view = views_[track];
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const View& other = views_[i];
    if (!tracks[i].confirmed || tracks[i].refused || other.range + kNearer > view.range) continue;
    // Its middle behind the other: about half of it.
    if (std::abs(wrap_angle(view.bearing - other.bearing)) < other.half_angle) return true;
  }
  return false;
}

}  // namespace lanefuse
