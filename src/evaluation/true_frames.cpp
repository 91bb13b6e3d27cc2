// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/true_frames.hpp"

#include <algorithm>
#include <cmath>

namespace lanefuse {
namespace {

TrueFrame between(const TrueFrame& before, const TrueFrame& after, double fraction) {
  TrueFrame frame;
  frame.world_from_vehicle = interpolate(before.world_from_vehicle, after.world_from_vehicle, fraction);
  frame.speed = std::lerp(before.speed, after.speed, fraction);
  frame.yaw_rate = std::lerp(before.yaw_rate, after.yaw_rate, fraction);
  for (TrueObject object : before.objects) {
    const auto later = std::find_if(after.objects.begin(), after.objects.end(),
                                    [&object](const TrueObject& other) { return other.id == object.id; });
    if (later == after.objects.end()) continue;
    object.world_from_object = interpolate(object.world_from_object, later->world_from_object, fraction);
    object.speed = std::lerp(object.speed, later->speed, fraction);
    frame.objects.push_back(object);
  }
  return frame;
}

}  // namespace

std::optional<TrueFrame> frame_at(std::span<const TrueFrame> frames, Time time) {
  const auto after = std::lower_bound(frames.begin(), frames.end(), time,
                                      [](const TrueFrame& frame, Time t) { return frame.time < t; });
  if (after == frames.end()) return std::nullopt;
  if (after->time == time) return *after;
  if (after == frames.begin()) return std::nullopt;
  const TrueFrame& before = *(after - 1);
  const Duration gap = after->time - before.time;
  if (gap > kLargestFrameGap) return std::nullopt;
  TrueFrame frame = between(before, *after, to_seconds(time - before.time) / to_seconds(gap));
  frame.time = time;
  return frame;
}

}  // namespace lanefuse
