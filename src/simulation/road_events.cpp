// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/road_events.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "simulation/construction_zone.hpp"
#include "simulation/missing_paint.hpp"
#include "simulation/ramps.hpp"

namespace lanefuse {
namespace {

/// One event at its place.
struct Occurrence {
  const RoadEvent* event;
  Stretch stretch;
};

bool changes_lanes(RoadEvent::Kind kind) {
  return kind != RoadEvent::Kind::missing_paint && kind != RoadEvent::Kind::rail_ghosts;
}

Occurrence occurrence_at(const RoadEvent& event, double begin, double road_length) {
  const double length = event.length > 0 ? event.length : usual_length(event.kind);
  const double end = length > 0 ? begin + length : road_length;
  return {&event, {begin, changes_lanes(event.kind) ? end : std::min(end, road_length)}};
}

std::vector<Occurrence> occurrences(std::span<const RoadEvent> events, double start, double road_length) {
  std::vector<Occurrence> all;
  for (const RoadEvent& event : events) {
    for (double begin = start + event.first; begin < road_length; begin += event.every) {
      const Occurrence occurrence = occurrence_at(event, begin, road_length);
      if (occurrence.stretch.end <= road_length) all.push_back(occurrence);
      if (event.every <= 0) break;
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Occurrence& a, const Occurrence& b) {
    return a.stretch.begin < b.stretch.begin;
  });
  return all;
}

/// The road between two events that change lanes must be a plain one, or lines would cross.
void check_apart(const std::vector<Occurrence>& all, double start) {
  const Occurrence* last = nullptr;
  for (const Occurrence& next : all) {
    if (!changes_lanes(next.event->kind)) continue;
    if (last && next.stretch.begin < last->stretch.end) {
      throw configuration_error(
          next.event->place,
          fmt::format("the {} from {} m and the {} from {} m overlap", to_string(last->event->kind),
                      last->stretch.begin - start, to_string(next.event->kind), next.stretch.begin - start),
          "set them further apart");
    }
    last = &next;
  }
}

void lay(const Occurrence& occurrence, RoadDraft& draft, Random& random) {
  const Stretch& stretch = occurrence.stretch;
  switch (occurrence.event->kind) {
    case RoadEvent::Kind::exit:
      return add_exit(draft, stretch);
    case RoadEvent::Kind::entry:
      return add_entry(draft, stretch);
    case RoadEvent::Kind::lane_drop:
      return add_ending_lane(draft, stretch);
    case RoadEvent::Kind::construction:
      return add_construction_zone(draft, stretch, random);
    case RoadEvent::Kind::missing_paint:
      return remove_paint(draft, *occurrence.event, stretch, random);
    case RoadEvent::Kind::rail_ghosts:
      return add_rail_ghosts(draft, stretch);
  }
}

}  // namespace

const char* to_string(RoadEvent::Kind kind) {
  switch (kind) {
    case RoadEvent::Kind::exit:
      return "exit";
    case RoadEvent::Kind::entry:
      return "entry";
    case RoadEvent::Kind::lane_drop:
      return "lane_drop";
    case RoadEvent::Kind::construction:
      return "construction";
    case RoadEvent::Kind::missing_paint:
      return "missing_paint";
    case RoadEvent::Kind::rail_ghosts:
      return "rail_ghosts";
  }
  return "?";
}

double usual_length(RoadEvent::Kind kind) {
  switch (kind) {
    case RoadEvent::Kind::exit:
    case RoadEvent::Kind::entry:
      return kRampLane + kRamp;
    case RoadEvent::Kind::lane_drop:
      return 800;
    case RoadEvent::Kind::construction:
      return 1000;
    case RoadEvent::Kind::rail_ghosts:
      return 400;
    case RoadEvent::Kind::missing_paint:
      break;
  }
  return 0;
}

void lay_events(std::span<const RoadEvent> events, double start, RoadDraft& draft, Random& random) {
  const std::vector<Occurrence> all = occurrences(events, start, draft.length());
  check_apart(all, start);
  for (const Occurrence& occurrence : all) {
    if (changes_lanes(occurrence.event->kind)) lay(occurrence, draft, random);
  }
  // Paint goes last, from all lines that there are by then; so do ghosts, which follow the rails.
  for (const Occurrence& occurrence : all) {
    if (!changes_lanes(occurrence.event->kind)) lay(occurrence, draft, random);
  }
}

}  // namespace lanefuse
