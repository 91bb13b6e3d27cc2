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
    view.quarter = std::atan2(tracks[i].width / 4, view.range);
    measure_body(tracks[i], sensor_from_odometry, view);
    const bool inside = look.field.contains(view.range / kEdge, view.bearing / kEdge);
    view.detection = inside ? look.field.detection_at(view.range) : 0;
  }
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (views_[i].detection > 0 && hidden(i, tracks)) views_[i].detection = 0;
  }
}

void TrackSight::measure_body(const ObjectTrack& track, const Pose2& sensor_from_odometry, View& view) {
  const Eigen::Vector2d ahead(std::cos(track.heading), std::sin(track.heading));
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  view.left = view.right = 0;
  for (const double along : {0.0, track.length()}) {
    for (const double across : {-track.width / 2, track.width / 2}) {
      const Eigen::Vector2d corner =
          sensor_from_odometry * Eigen::Vector2d(track.position() + along * ahead + across * left);
      const double angle = wrap_angle(std::atan2(corner.y(), corner.x()) - view.bearing);
      view.left = std::max(view.left, angle);
      view.right = std::min(view.right, angle);
    }
  }
}

bool TrackSight::hidden(std::size_t track, std::span<const ObjectTrack> tracks) const {
  constexpr double kNearer = 3;  // [m]
  const View& view = views_[track];
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const View& other = views_[i];
    if (!tracks[i].confirmed || tracks[i].refused || other.range + kNearer > view.range) continue;
    // More than a quarter of it behind the other.
    const double apart = wrap_angle(view.bearing - other.bearing);
    if (apart < other.left && apart > other.right) return true;
  }
  return false;
}

}  // namespace lanefuse
