// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/drive_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "drawing/legend.hpp"
#include "drawing/map_frame.hpp"

namespace lanefuse {
namespace {

constexpr double kDriveWidth = 1140;
constexpr double kDriveHeight = 520;
constexpr double kMomentWidth = 560;
constexpr double kMomentHeight = 420;
constexpr double kTitleHeight = 66;
constexpr std::size_t kMostPlaces = 300;

struct Level {
  double below;  // [m]
  const char* label;
  const char* css;
};
constexpr std::array kLevels{
    Level{0.15, "below 0.15 m", "pen-series-4 medium"}, Level{0.3, "0.15-0.3 m", "pen-series-0 medium"},
    Level{0.6, "0.3-0.6 m", "pen-base thick"},
    Level{std::numeric_limits<double>::infinity(), "0.6 m and more", "pen-truth thick"}};
constexpr const char* kNoAnswer = "pen-muted thin dashed";

/// NaN is an error that is not known.
const char* css_of(double error) {
  for (const Level& level : kLevels) {
    if (error < level.below) return level.css;
  }
  return kNoAnswer;
}

/// Takes so many places together that few enough are left: their first position, and the RMS of the errors
/// that are known.
ErrorTrace thinned(const ErrorTrace& trace) {
  const std::size_t together = (trace.size() + kMostPlaces - 1) / kMostPlaces;
  ErrorTrace result;
  for (std::size_t begin = 0; begin < trace.size(); begin += together) {
    double squares = 0;
    int known = 0;
    for (std::size_t i = begin; i < std::min(begin + together, trace.size()); ++i) {
      if (!std::isfinite(trace[i].error)) continue;
      squares += trace[i].error * trace[i].error;
      ++known;
    }
    result.push_back({trace[begin].position, known == 0 ? std::nan("") : std::sqrt(squares / known)});
  }
  return result;
}

std::vector<LegendEntry> level_legend() {
  std::vector<LegendEntry> legend;
  for (const Level& level : kLevels) legend.push_back({level.label, level.css, std::nullopt, ""});
  legend.push_back({"no answer", kNoAnswer, std::nullopt, ""});
  legend.push_back({"start", "", Marker::circle, "text"});
  return legend;
}

/// Places of one level in a row make one line; a gap of this size is a jump, and no way.
constexpr double kJump = 200;  // [m]

void draw_way(SvgWriter& svg, const MapFrame& map, const ErrorTrace& places) {
  std::vector<Pixel> line;
  const char* css = nullptr;
  const auto flush = [&] {
    if (css) svg.polyline(line, fmt::format("{} round", css));
    line.clear();
  };
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const bool jump = (places[i + 1].position - places[i].position).norm() > kJump;
    if (css != css_of(places[i].error) || line.empty()) {
      flush();
      css = css_of(places[i].error);
      line.push_back(map.at(places[i].position));
    }
    if (jump) {
      flush();
    } else {
      line.push_back(map.at(places[i + 1].position));
    }
  }
  flush();
}

/// What one moment shows of a line, in the world.
std::vector<Eigen::Vector2d> in_world(const std::vector<Eigen::Vector2d>& line,
                                      const Pose2& world_from_vehicle) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d& point : line) {
    if (point.x() >= -10 && point.x() <= 130) points.push_back(world_from_vehicle * point);
  }
  return points;
}

std::vector<Eigen::Vector2d> points_of(const Boundary& boundary) {
  std::vector<Eigen::Vector2d> points;
  for (const BoundaryPoint& point : boundary.points) points.emplace_back(point.x, point.y);
  return points;
}

void draw_line(SvgWriter& svg, const MapFrame& map, const std::vector<Eigen::Vector2d>& line,
               const char* css) {
  std::vector<Pixel> pixels;
  for (const Eigen::Vector2d& point : line) pixels.push_back(map.at(point));
  svg.polyline(pixels, css);
}

Figure shifted_down(const SvgWriter& head, const SvgWriter& map, double width, double height,
                    std::string label) {
  const std::string body =
      fmt::format("<svg x=\"0\" y=\"{}\" width=\"{}\" height=\"{:.1f}\">\n", kTitleHeight, width, height) +
      map.elements() + "</svg>\n";
  return {width, kTitleHeight + height, std::move(label), head.elements() + body};
}

}  // namespace

Figure draw_drive_map(const ErrorTrace& trace) {
  const ErrorTrace places = thinned(trace);
  std::vector<Eigen::Vector2d> positions;
  for (const ErrorAtPlace& place : places) positions.push_back(place.position);
  const MapFrame map(positions, kDriveWidth, kDriveHeight, levelling_angle(positions));
  SvgWriter head;
  head.text({4, 20}, "Error of the ego lane's boundaries 60 m ahead, along the drive", "heading ink-text");
  draw_legend(head, {4, 42}, kDriveWidth - 8, level_legend());
  SvgWriter svg;
  draw_way(svg, map, places);
  if (!positions.empty()) svg.circle(map.at(positions.front()), 4.5, "ink-text");
  map.draw_scale(svg);
  return shifted_down(head, svg, kDriveWidth, map.height(), "the drive from above, coloured by error");
}

Figure draw_on_map(const TopView& view, const Pose2& world_from_vehicle) {
  std::vector<std::vector<Eigen::Vector2d>> truth, estimate;
  for (const auto& line : view.true_boundaries) truth.push_back(in_world(line, world_from_vehicle));
  for (const Boundary& boundary : view.estimate.boundaries) {
    estimate.push_back(in_world(points_of(boundary), world_from_vehicle));
  }
  std::vector<Eigen::Vector2d> all{world_from_vehicle.position()};
  for (const auto* lines : {&truth, &estimate}) {
    for (const auto& line : *lines) all.insert(all.end(), line.begin(), line.end());
  }
  const MapFrame map(all, kMomentWidth, kMomentHeight);
  SvgWriter head;
  head.text({4, 20}, "On the map, " + view.title, "heading ink-text");
  draw_legend(head, {4, 42}, kMomentWidth - 8,
              {{"estimate", "pen-truth medium", std::nullopt, ""},
               {"truth", "pen-series-0 medium dashed", std::nullopt, ""},
               {"car", "", Marker::cross, "text"}});
  SvgWriter svg;
  for (const auto& line : estimate) draw_line(svg, map, line, "pen-truth medium round");
  for (const auto& line : truth) draw_line(svg, map, line, "pen-series-0 medium dashed");
  draw_marker(svg, Marker::cross, map.at(world_from_vehicle.position()), 5, "text");
  map.draw_scale(svg);
  return shifted_down(head, svg, kMomentWidth, map.height(), "estimate and truth on the map");
}

}  // namespace lanefuse
