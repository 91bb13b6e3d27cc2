// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/track_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "drawing/axes.hpp"
#include "drawing/label_places.hpp"
#include "drawing/legend.hpp"
#include "drawing/thinned_line.hpp"

namespace lanefuse {
namespace {

constexpr double kLeft = 46;
constexpr double kRight = 18;
constexpr double kTop = 88;
constexpr double kAheadHeight = 380;
constexpr double kBetween = 70;
constexpr double kLeftHeight = 220;
constexpr double kFoot = 44;
constexpr double kPixelsPerSecond = 14;
constexpr double kNarrowest = 620;  // [px] of the axes
constexpr double kWidest = 4000;
constexpr double kLongestGap = 0.5;  // [s] without a word that a line runs through
constexpr double kTolerance = 0.35;  // [px]

constexpr const char* kStandingColour = "series-3";
constexpr std::array<const char*, 8> kPalette{"series-0", "series-1", "series-2", "series-4",
                                              "series-5", "outlier",  "serial",   "objects"};

/// A life with its colour: grey where it stands, all along or for a time.
struct Line {
  const TrackedLife* life;
  const char* colour;
  [[nodiscard]] const char* colour_in(TrackRole role) const {
    return role == TrackRole::standing ? kStandingColour : colour;
  }
  [[nodiscard]] std::string css(TrackRole role) const {
    return fmt::format("pen-{} {} round", colour_in(role), role == TrackRole::witness ? "thick" : "thin");
  }
};

/// [s] for which both were there, and a little before and after: who comes next shall not look the same.
double together(const TrackedLife& a, const TrackedLife& b) {
  constexpr double kMargin = 3;  // [s]
  const double begin = std::max(a.moments.front().seconds, b.moments.front().seconds);
  const double end = std::min(a.moments.back().seconds, b.moments.back().seconds);
  return std::max(0.0, end - begin + kMargin);
}

/// The colour that is shared for the shortest time with others, the next in turn among equals.
const char* free_colour(const TrackedLife& life, const std::vector<Line>& lines) {
  std::array<double, kPalette.size()> shared{};
  for (const Line& line : lines) {
    const auto at = std::find(kPalette.begin(), kPalette.end(), std::string_view(line.colour));
    if (at != kPalette.end())
      shared[static_cast<std::size_t>(at - kPalette.begin())] += together(life, *line.life);
  }
  std::size_t best = lines.size() % kPalette.size();
  for (std::size_t i = 0; i < kPalette.size(); ++i) {
    const std::size_t next = (lines.size() + i) % kPalette.size();
    if (shared[next] < shared[best]) best = next;
  }
  return kPalette[best];
}

std::vector<Line> coloured(const std::vector<TrackedLife>& lives) {
  std::vector<Line> lines;
  for (const TrackedLife& life : lives) {
    const bool drove = life.was(TrackRole::witness) || life.was(TrackRole::driving);
    lines.push_back({&life, drove ? free_colour(life, lines) : kStandingColour});
  }
  return lines;
}

using Value = double TrackMoment::*;

/// From tick to tick around all values; of those that drive only, where there are any and `driving` asks so.
Axis axis_around(std::string label, const std::vector<TrackedLife>& lives, Value value, bool driving) {
  double least = 0;
  double most = 0;
  for (const TrackedLife& life : lives) {
    for (const TrackMoment& moment : life.moments) {
      if (driving && moment.role == TrackRole::standing) continue;
      least = std::min(least, moment.*value);
      most = std::max(most, moment.*value);
    }
  }
  const double step = nice_step(std::max(most - least, 1.0), 12);
  return {std::move(label), step * std::floor(least / step), step * std::max(1.0, std::ceil(most / step)),
          step};
}

/// The moments in pieces of one role; a piece ends where the next begins, so that the line does not break.
template <typename Visit>
void for_each_piece(const TrackedLife& life, Visit visit) {
  const auto& moments = life.moments;
  for (std::size_t begin = 0; begin < moments.size();) {
    std::size_t end = begin + 1;
    const auto follows = [&] { return moments[end].seconds - moments[end - 1].seconds < kLongestGap; };
    while (end < moments.size() && follows() && moments[end].role == moments[begin].role) ++end;
    const bool joined = end < moments.size() && follows();
    visit(begin, joined ? end + 1 : end);
    begin = end;
  }
}

std::vector<Pixel> pixels_of(const TrackedLife& life, const Axes& axes, Value value) {
  std::vector<Pixel> pixels;
  for (const TrackMoment& moment : life.moments) pixels.push_back(axes.at(moment.seconds, moment.*value));
  return pixels;
}

void draw_line(SvgWriter& svg, const Line& line, const std::vector<Pixel>& pixels) {
  for_each_piece(*line.life, [&](std::size_t begin, std::size_t end) {
    using Offset = std::ptrdiff_t;
    const std::vector<Pixel> piece(pixels.begin() + static_cast<Offset>(begin),
                                   pixels.begin() + static_cast<Offset>(end));
    svg.polyline(thinned_line(piece, kTolerance), line.css(line.life->moments[begin].role));
  });
}

/// What stood all along lies below what drove, and the labels lie above all.
void draw_panel(SvgWriter& svg, const Axes& axes, const std::vector<Line>& lines, Value value,
                bool with_seconds) {
  axes.draw(svg);
  LabelPlaces places(axes.frame());
  svg.begin_clip(axes.frame());
  for (const bool drives : {false, true}) {
    for (const Line& line : lines) {
      if ((line.colour != std::string_view(kStandingColour)) != drives) continue;
      const std::vector<Pixel> pixels = pixels_of(*line.life, axes, value);
      draw_line(svg, line, pixels);
      places.occupy(pixels);
    }
  }
  // Whoever was kept long finds room first.
  std::vector<Line> by_length = lines;
  std::stable_sort(by_length.begin(), by_length.end(),
                   [](const Line& a, const Line& b) { return a.life->kept() > b.life->kept(); });
  for (const Line& line : by_length) {
    const std::string text = with_seconds ? fmt::format("{}: {:.0f} s", line.life->id, line.life->kept())
                                          : fmt::format("{}", line.life->id);
    const auto place = places.beside(pixels_of(*line.life, axes, value), text);
    if (!place) continue;
    svg.rectangle(*place, "ink-paper faint");
    svg.text({place->left + 2, place->bottom() - 3}, text, fmt::format("tick number ink-{}", line.colour));
  }
  svg.end_clip();
}

}  // namespace

Figure draw_tracks(const std::string& title, const TrackHistory& history) {
  const std::vector<TrackedLife> lives = history.lives();
  const std::vector<Line> lines = coloured(lives);
  const double inner = std::clamp(kPixelsPerSecond * history.duration(), kNarrowest, kWidest);
  const double seconds = std::max(history.duration(), 1.0);
  const Axis time{"time [s]", 0, seconds, nice_step(seconds, static_cast<int>(inner / 70))};
  const Box upper{kLeft, kTop, inner, kAheadHeight};
  const Box lower{kLeft, upper.bottom() + kBetween, inner, kLeftHeight};
  SvgWriter svg;
  svg.text({4, 20}, title, "heading ink-text");
  draw_legend(svg, {4, 44}, inner,
              {{"bears witness of its lane", "pen-series-0 thick", std::nullopt, ""},
               {"drives, but is no witness", "pen-series-0 thin", std::nullopt, ""},
               {"stands", "pen-series-3 thin", std::nullopt, ""},
               {"\"7: 12 s\": id, and how long it was kept", "", std::nullopt, ""}});
  const Axes ahead(upper, time, axis_around("distance ahead [m]", lives, &TrackMoment::ahead, false));
  draw_panel(svg, ahead, lines, &TrackMoment::ahead, true);
  const Axes left(lower, time, axis_around("to the left [m]", lives, &TrackMoment::left, true));
  draw_panel(svg, left, lines, &TrackMoment::left, false);
  if (lives.empty()) {
    svg.text({upper.left + inner / 2, upper.top + kAheadHeight / 2}, "no tracks", "heading ink-muted",
             Anchor::middle);
  }
  return {kLeft + inner + kRight, lower.bottom() + kFoot, title, svg.elements()};
}

}  // namespace lanefuse
