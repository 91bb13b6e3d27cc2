// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/error.hpp"
#include "roadmap/group_layout.hpp"
#include "roadmap/map_text.hpp"
#include "roadmap/opendrive.hpp"
#include "roadmap/opendrive_frame.hpp"
#include "roadmap/opendrive_lanes_text.hpp"
#include "roadmap/opendrive_plan.hpp"

namespace lanefuse {
namespace {

std::string header_text(const RoadMap& map) {
  std::string text = fmt::format(
      "  <header revMajor=\"1\" revMinor=\"6\" name=\"{}\" version=\"1.00\" "
      "north=\"0\" south=\"0\" east=\"0\" west=\"0\">\n",
      xml_escaped(map.name));
  if (map.origin) {
    text += fmt::format("    <geoReference><![CDATA[{}]]></geoReference>\n", geo_reference_text(*map.origin));
    text += fmt::format("    <offset x=\"0\" y=\"0\" z=\"{}\" hdg=\"0\"/>\n", map.origin->height);
  }
  return text + "  </header>\n";
}

std::string elevation_text(const GroupLayout& layout) {
  const BoundaryOffsets& heights = layout.longest();
  std::vector<double> bends = heights.height_bends();
  bends.insert(bends.begin(), 0);
  std::string text = "    <elevationProfile>\n";
  double last = -1;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const double to = i + 1 < bends.size() ? bends[i + 1] : layout.plan().end();
    const double from = std::max(0.0, bends[i]);
    if (from <= last || to - from < 1e-6) continue;
    const double height = heights.height(from);
    text += fmt::format("      <elevation s=\"{:.10g}\" a=\"{:.10g}\" b=\"{:.10g}\" c=\"0\" d=\"0\"/>\n",
                        from, height, (heights.height(to) - height) / (to - from));
    last = from;
  }
  return text + "    </elevationProfile>\n";
}

std::string road_text(const RoadMap& map, const GroupLayout& layout, std::size_t id,
                      const std::string& place) {
  return fmt::format("  <road name=\"\" length=\"{:.12g}\" id=\"{}\" junction=\"-1\" rule=\"RHT\">\n",
                     layout.plan().end(), id) +
         "    <type s=\"0\" type=\"motorway\"/>\n" + plan_view_text(layout.plan()) + elevation_text(layout) +
         opendrive_lanes_text(map, layout, place) + "  </road>\n";
}

}  // namespace

std::string opendrive_text(const RoadMap& map, const ExactPlan* plan) {
  const std::string place = map.name.empty() ? "the map" : map.name;
  check(map, place);
  if (map.lanes.empty()) throw input_error(place, "has no lanes");
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenDRIVE>\n" + header_text(map);
  const std::vector<LaneGroup> groups = lane_groups(map);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const GroupLayout layout(map, groups[i], groups.size() == 1 ? plan : nullptr, place);
    text += road_text(map, layout, i + 1, place);
  }
  return text + "</OpenDRIVE>\n";
}

}  // namespace lanefuse
