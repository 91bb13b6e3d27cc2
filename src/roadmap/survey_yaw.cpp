// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/survey_yaw.hpp"

#include <cmath>

namespace lanefuse {
namespace {

constexpr double kNear = 2;           ///< [m] ahead
constexpr double kFar = 14;           ///< [m] ahead
constexpr double kSameLine = 0.6;     ///< [m]
constexpr double kLargestYaw = 0.05;  ///< [rad]: beyond it the camera sees something else

/// How far to the left of its line the marking lies at `x`, its paint's half width included; unknown where it
/// has no line.
double off_line(const SeenMarking& marking, double x, const Pose2& map_from_vehicle, const SurveyAxis& axis,
                std::span<const SurveyLine> lines, std::size_t& hint) {
  const auto place = axis.locate(map_from_vehicle * Eigen::Vector2d(x, marking.line.y(x)), hint);
  if (!place) return kUnknown;
  const double at = place->station / axis.step();
  if (at < 0) return kUnknown;
  const auto station = static_cast<std::size_t>(at);
  for (const SurveyLine& line : lines) {
    if (station + 1 >= line.lateral.size()) continue;
    const double share = at - static_cast<double>(station);
    const double lateral = (1 - share) * line.lateral[station] + share * line.lateral[station + 1];
    if (std::abs(place->lateral - lateral) < kSameLine) return place->lateral - lateral;
  }
  return kUnknown;
}

}  // namespace

StationSeries camera_yaw(const TraceInput& input, std::span<const SurveyLine> lines, double reach) {
  const SurveyAxis& axis = input.axis;
  StationSeries sums(axis.knot_count(), 0);
  std::vector<int> counts(axis.knot_count(), 0);
  std::optional<std::size_t> hint;
  for (const SeenMarking& marking : input.drive.markings) {
    const auto pose = pose_at(input.drive.track, marking.time);
    if (!pose) continue;
    if (!hint) hint = axis.nearest_knot(pose->position());
    const double far = off_line(marking, kFar, *pose, axis, lines, *hint);
    const double near = off_line(marking, kNear, *pose, axis, lines, *hint);
    const double yaw = (far - near) / (kFar - kNear);
    if (!is_known(yaw) || std::abs(yaw) > kLargestYaw) continue;
    sums[*hint] += yaw;
    ++counts[*hint];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] > 0 ? sums[i] / counts[i] : kUnknown;
  return box_mean(sums, static_cast<std::size_t>(reach / axis.step()));
}

}  // namespace lanefuse
