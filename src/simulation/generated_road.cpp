// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/generated_road.hpp"

#include <utility>

#include "core/random.hpp"
#include "simulation/road_course.hpp"
#include "simulation/road_events.hpp"

namespace lanefuse {
namespace {

constexpr Range kSharpRadius{250, 500};  ///< [m], the scene of sharp bends; the preset knows the other two

Range radius_of(RoadKind kind, const RoadPreset& preset) {
  switch (kind) {
    case RoadKind::gentle:
      return preset.gentle_radius;
    case RoadKind::curved:
      return preset.curved_radius;
    case RoadKind::sharp:
      break;
  }
  return kSharpRadius;
}

}  // namespace

Road generated_road(const RoadPlan& plan, const RoadPreset& preset, std::uint64_t seed) {
  Random shape(seed, "road");
  Random heights(seed, "road height");
  Random chances(seed, "road events");
  ReferenceLine reference(draw_road_course(radius_of(plan.kind, preset), plan.length, shape));
  RoadHeight height(preset, reference.length(), heights);
  RoadDraft draft(preset, reference.length(), shape);
  lay_events(plan.events, plan.start, draft, chances);
  return {std::move(reference), std::move(height), draft.finished()};
}

}  // namespace lanefuse
