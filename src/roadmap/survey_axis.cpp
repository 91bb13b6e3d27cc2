// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_axis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lanefuse {
namespace {

constexpr double kFarthest = 60;  ///< [m] across, that still belongs to the road

double distance(const Pose2& from, const Pose2& to) { return (to.position() - from.position()).norm(); }

}  // namespace

double length_of(std::span<const TrackNode> track) {
  double length = 0;
  for (std::size_t i = 1; i < track.size(); ++i) {
    length += distance(track[i - 1].map_from_vehicle, track[i].map_from_vehicle);
  }
  return length;
}

SurveyAxis::SurveyAxis(std::span<const TrackNode> track, double step) : step_(step) {
  assert(track.size() >= 2 && step > 0);
  double to_next = 0;  // way from the node to the next knot
  for (std::size_t i = 1; i < track.size(); ++i) {
    const Pose2& from = track[i - 1].map_from_vehicle;
    const Pose2& to = track[i].map_from_vehicle;
    const double way = distance(from, to);
    double at = to_next;
    for (; at <= way && way > 0; at += step) {
      const double fraction = at / way;
      knots_.push_back(interpolate(from, to, fraction));
      heights_.push_back(track[i - 1].height + fraction * (track[i].height - track[i - 1].height));
    }
    to_next = at - way;
  }
}

double SurveyAxis::ahead_of(std::size_t knot, const Eigen::Vector2d& point) const {
  const Pose2& pose = knots_[knot];
  return (point - pose.position()).dot(Eigen::Vector2d(std::cos(pose.heading), std::sin(pose.heading)));
}

std::size_t SurveyAxis::nearest_knot(const Eigen::Vector2d& point) const {
  const auto nearer = [&point](const Pose2& a, const Pose2& b) {
    return (a.position() - point).squaredNorm() < (b.position() - point).squaredNorm();
  };
  return static_cast<std::size_t>(std::min_element(knots_.begin(), knots_.end(), nearer) - knots_.begin());
}

std::optional<SurveyAxis::Place> SurveyAxis::locate(const Eigen::Vector2d& point, std::size_t& hint) const {
  if (knots_.size() < 2) return std::nullopt;
  std::size_t i = std::min(hint, knots_.size() - 2);
  while (i + 2 < knots_.size() && ahead_of(i + 1, point) >= 0) ++i;
  while (i > 0 && ahead_of(i, point) < 0) --i;
  const double from = ahead_of(i, point);
  const double to = ahead_of(i + 1, point);
  if (!(from >= 0 && to <= 0 && from > to)) return std::nullopt;
  hint = i;
  double fraction = from / (from - to);
  Eigen::Vector2d local = interpolate(knots_[i], knots_[i + 1], fraction).inverse() * point;
  fraction += local.x() / step_;
  local = interpolate(knots_[i], knots_[i + 1], fraction).inverse() * point;
  if (std::abs(local.y()) > kFarthest) return std::nullopt;
  return Place{(static_cast<double>(i) + fraction) * step_, local.y()};
}

}  // namespace lanefuse
