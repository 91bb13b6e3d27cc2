// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "roadmap/opendrive_lanes_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr double kGap = 0.001;     // [m] narrower is none
constexpr double kOverlap = 0.30;  // [m] wider cannot be drawing inaccuracy

/// One strip of a section from left to right; without a lane it fills the gap between two.
struct Strip {
  const MapLane* lane = nullptr;
  std::uint64_t left = 0;   ///< boundary
  std::uint64_t right = 0;  ///< boundary
};

struct Section {
  double from = 0;
  double to = 0;
  std::vector<Strip> strips;
};

const char* type_of(const Strip& strip) {
  if (!strip.lane) return "none";
  switch (strip.lane->kind) {
    case LaneKind::driving:
      return "driving";
    case LaneKind::emergency:
      return "shoulder";
    case LaneKind::entry:
      return "entry";
    case LaneKind::exit:
      return "exit";
    case LaneKind::other:
      return "special1";
  }
  return "none";
}

const char* mark_type(MarkingType type) {
  switch (type) {
    case MarkingType::unknown:
      return "none";
    case MarkingType::solid:
      return "solid";
    case MarkingType::dashed:
      return "broken";
    case MarkingType::road_edge:
      return "edge";
    case MarkingType::guard_rail:
      return "custom";
  }
  return "none";
}

const char* mark_colour(MarkingColour colour) {
  if (colour == MarkingColour::unknown) return "standard";
  return colour == MarkingColour::yellow ? "yellow" : "white";
}

std::string mark_text(const MarkingStyle& style, double offset) {
  const std::string attributes =
      fmt::format(R"(sOffset="{:.10g}" type="{}" weight="{}" color="{}" width="{:.6g}" laneChange="{}")",
                  offset, mark_type(style.marking.type), style.width > 0.2 ? "bold" : "standard",
                  mark_colour(style.marking.colour), style.width,
                  style.marking.type == MarkingType::dashed ? "both" : "none");
  if (style.marking.type != MarkingType::guard_rail)
    return fmt::format("          <roadMark {}/>\n", attributes);
  return fmt::format(
      R"(          <roadMark {}><type name="guard_rail" width="{:.6g}"><line length="0" space="0" tOffset="0" )"
      R"(sOffset="0" width="{:.6g}"/></type></roadMark>)"
      "\n",
      attributes, style.width, style.width);
}

/// Writes one road's sections.
class LanesText {
 public:
  LanesText(const RoadMap& map, const GroupLayout& layout, const std::string& place)
      : map_(map), layout_(layout), place_(place) {
    const std::vector<double>& stations = layout.section_stations();
    for (std::size_t i = 1; i < stations.size(); ++i) add_section(stations[i - 1], stations[i]);
    check_successors();
  }

  [[nodiscard]] std::string text() const {
    std::string text = "    <lanes>\n";
    for (const Section& section : sections_) text += lane_offset_text(section);
    for (std::size_t i = 0; i < sections_.size(); ++i) text += section_text(i);
    return text + "    </lanes>\n";
  }

 private:
  void add_section(double from, double to) {
    Section section{from, to, {}};
    for (const MapLane* lane : layout_.lanes_between(from, to)) {
      if (!section.strips.empty() && section.strips.back().right != lane->left_boundary) {
        section.strips.push_back({nullptr, section.strips.back().right, lane->left_boundary});
      }
      section.strips.push_back({lane, lane->left_boundary, lane->right_boundary});
    }
    for (const Strip& strip : section.strips) check_width(strip, (from + to) / 2);
    sections_.push_back(std::move(section));
  }

  void check_width(const Strip& strip, double station) const {
    if (width(strip, station) >= -kOverlap) return;
    throw input_error(fmt::format("{}, boundary {}", place_, strip.right),
                      fmt::format("lies to the left of boundary {}, so that lanes overlap", strip.left),
                      "OpenDRIVE cannot tell such a road; write Lanelet2 or GeoJSON");
  }

  [[nodiscard]] double width(const Strip& strip, double station) const {
    return layout_.offsets(strip.left).offset(station) - layout_.offsets(strip.right).offset(station);
  }

  /// OpenDRIVE links lanes only where one section meets the next.
  void check_successors() const {
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      for (const Strip& strip : sections_[i].strips) {
        if (!strip.lane || lane_id(i + 1, *strip.lane)) continue;  // goes on itself
        for (const std::uint64_t next : strip.lane->successors) {
          const MapLane* lane = find_lane(map_, next);
          if (lane_id(i + 1, *lane) && !lane_id(i, *lane)) continue;
          throw input_error(fmt::format("{}, lane {}", place_, strip.lane->id),
                            fmt::format("is followed by lane {}, which does not begin where it ends", next),
                            "OpenDRIVE cannot tell such a road; write Lanelet2 or GeoJSON");
        }
      }
    }
  }

  /// The id that the lane has in a section, if it is there.
  [[nodiscard]] std::optional<int> lane_id(std::size_t section, const MapLane& lane) const {
    if (section >= sections_.size()) return std::nullopt;
    const std::vector<Strip>& strips = sections_[section].strips;
    const auto found =
        std::find_if(strips.begin(), strips.end(), [&](const Strip& strip) { return strip.lane == &lane; });
    return found == strips.end() ? std::nullopt
                                 : std::optional(-1 - static_cast<int>(found - strips.begin()));
  }

  /// A quantity that runs straight between bends, as records of value and slope.
  template <typename Value, typename Record>
  static std::string records(std::vector<double> bends, const Section& section, Value value, Record record) {
    bends.push_back(section.from);
    std::erase_if(bends, [&](double at) { return at < section.from || at >= section.to - kGap; });
    std::sort(bends.begin(), bends.end());
    bends.erase(std::unique(bends.begin(), bends.end(), [](double a, double b) { return b - a < kGap; }),
                bends.end());
    std::string text;
    for (std::size_t i = 0; i < bends.size(); ++i) {
      const double to = i + 1 < bends.size() ? bends[i + 1] : section.to;
      text += record(bends[i], value(bends[i]), (value(to) - value(bends[i])) / (to - bends[i]));
    }
    return text;
  }

  [[nodiscard]] std::string lane_offset_text(const Section& section) const {
    const BoundaryOffsets* leftmost =
        section.strips.empty() ? nullptr : &layout_.offsets(section.strips[0].left);
    return records(
        leftmost ? leftmost->bends() : std::vector<double>{}, section,
        [&](double at) { return leftmost ? leftmost->offset(at) : 0; },
        [](double at, double value, double slope) {
          return fmt::format(R"(      <laneOffset s="{:.10g}" a="{:.10g}" b="{:.10g}" c="0" d="0"/>)"
                             "\n",
                             at, value, slope);
        });
  }

  [[nodiscard]] std::string width_text(const Strip& strip, const Section& section) const {
    std::vector<double> bends = layout_.offsets(strip.left).bends();
    const std::vector<double>& others = layout_.offsets(strip.right).bends();
    bends.insert(bends.end(), others.begin(), others.end());
    return records(
        std::move(bends), section, [&](double at) { return std::max(0.0, width(strip, at)); },
        [&](double at, double value, double slope) {
          return fmt::format(R"(          <width sOffset="{:.10g}" a="{:.10g}" b="{:.10g}" c="0" d="0"/>)"
                             "\n",
                             at - section.from, value, slope);
        });
  }

  [[nodiscard]] std::string marks_text(std::uint64_t boundary_id, const Section& section) const {
    const MapBoundary& boundary = *find_boundary(map_, boundary_id);
    const BoundaryOffsets& offsets = layout_.offsets(boundary_id);
    std::string later;
    const MarkingStyle* first = &boundary.styles.front();
    for (const MarkingStyle& style : boundary.styles) {
      const double station = offsets.station_of(style.from);
      if (station <= section.from + kGap) first = &style;
      if (station > section.from + kGap && station < section.to)
        later += mark_text(style, station - section.from);
    }
    return mark_text(*first, 0) + later;
  }

  [[nodiscard]] std::string link_text(std::size_t section, const MapLane& lane) const {
    std::string links;
    if (section > 0) {
      for (const Strip& before : sections_[section - 1].strips) {
        const bool leads_here =
            before.lane &&
            (before.lane == &lane || (follows(*before.lane, lane) && !lane_id(section, *before.lane)));
        if (leads_here)
          links += fmt::format(R"(<predecessor id="{}"/>)", *lane_id(section - 1, *before.lane));
      }
    }
    const std::optional<int> itself = lane_id(section + 1, lane);
    if (itself) links += fmt::format(R"(<successor id="{}"/>)", *itself);
    for (const std::uint64_t next : lane.successors) {
      const std::optional<int> id = itself ? std::nullopt : lane_id(section + 1, *find_lane(map_, next));
      if (id) links += fmt::format(R"(<successor id="{}"/>)", *id);
    }
    return links.empty() ? "" : fmt::format("          <link>{}</link>\n", links);
  }

  static bool follows(const MapLane& before, const MapLane& after) {
    return std::find(before.successors.begin(), before.successors.end(), after.id) != before.successors.end();
  }

  [[nodiscard]] std::string section_text(std::size_t index) const {
    const Section& section = sections_[index];
    std::string text = fmt::format("      <laneSection s=\"{:.10g}\">\n        <center>\n", section.from);
    text += "        <lane id=\"0\" type=\"none\" level=\"false\">\n";
    if (!section.strips.empty()) text += marks_text(section.strips[0].left, section);
    text += "        </lane>\n        </center>\n";
    if (!section.strips.empty()) text += "        <right>\n";
    int id = 0;
    for (const Strip& strip : section.strips) {
      text += fmt::format("        <lane id=\"{}\" type=\"{}\" level=\"false\">\n", --id, type_of(strip));
      if (strip.lane) text += link_text(index, *strip.lane);
      text += width_text(strip, section) + marks_text(strip.right, section) + "        </lane>\n";
    }
    if (!section.strips.empty()) text += "        </right>\n";
    return text + "      </laneSection>\n";
  }

  const RoadMap& map_;
  const GroupLayout& layout_;
  const std::string& place_;
  std::vector<Section> sections_;
};

}  // namespace

std::string opendrive_lanes_text(const RoadMap& map, const GroupLayout& layout, const std::string& place) {
  return LanesText(map, layout, place).text();
}

}  // namespace lanefuse
