// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/style.hpp"

#include <array>

#include <fmt/format.h>

namespace lanefuse {
namespace {

struct Colour {
  const char* css_class;
  const char* light;
  const char* dark;
};

/// A class of that name paints with that colour: as "ink-NAME" it fills, as "pen-NAME" it strokes.
constexpr std::array kColours{
    Colour{"text", "#1f2933", "#e4e7eb"},     Colour{"muted", "#5f6b7a", "#9aa5b4"},
    Colour{"grid", "#e3e8ee", "#2b323c"},     Colour{"frame", "#9aa5b1", "#596474"},
    Colour{"paper", "#ffffff", "#14181f"},    Colour{"series-0", "#0072b2", "#56b4e9"},
    Colour{"series-1", "#d55e00", "#f4935a"}, Colour{"series-2", "#7b3fa0", "#c79be0"},
    Colour{"series-3", "#6b7280", "#a3abb8"}, Colour{"series-4", "#00845e", "#35c79b"},
    Colour{"series-5", "#b8860b", "#e6bc4a"}, Colour{"serial", "#0b3c78", "#a9cdff"},
    Colour{"high-res", "#2f86d1", "#4fa3f0"}, Colour{"objects", "#1c9fb4", "#67d4e4"},
    Colour{"other", "#5b67c9", "#a5b2ff"},    Colour{"outlier", "#d01c8b", "#ff6ac1"},
    Colour{"boundary", "#00845e", "#2fc79a"}, Colour{"truth", "#c8102e", "#ff6b6b"},
    Colour{"base", "#e08a00", "#ffb83d"},     Colour{"vehicle", "#3e4c59", "#cbd2d9"},
};

constexpr const char* kShapes =
    "text{font-family:system-ui,-apple-system,'Segoe UI','Helvetica Neue',Arial,sans-serif}"
    ".tick{font-size:11px}.label{font-size:11.5px}.heading{font-size:13.5px;font-weight:600}"
    ".number{font-variant-numeric:tabular-nums}"
    ".hair{stroke-width:1;fill:none}.thin{stroke-width:1.2;fill:none}.medium{stroke-width:1.8;fill:none}"
    ".thick{stroke-width:2.4;fill:none}.dashed{stroke-dasharray:6 4}.dotted{stroke-dasharray:2 3}"
    ".round{stroke-linejoin:round;stroke-linecap:round}"
    ".faint{opacity:.55}.band{fill-opacity:.28}.wash{fill-opacity:.07}";

}  // namespace

std::string figure_css() {
  std::string light, dark;
  for (const auto& [name, on_light, on_dark] : kColours) {
    const auto rule = [name = name](const char* colour) {
      return fmt::format(".ink-{0}{{fill:{1}}}.pen-{0}{{stroke:{1}}}", name, colour);
    };
    light += rule(on_light);
    dark += rule(on_dark);
  }
  // Pens come with "fill:none" from their widths; inks must win over nothing, so the shapes stand first.
  return std::string(kShapes) + light + "@media(prefers-color-scheme:dark){" + dark + "}";
}

SourceStyle style_of(Source source) {
  switch (source) {
    case Source::serial_camera:
      return {Marker::circle, "serial", "serial camera"};
    case Source::high_resolution_camera:
      return {Marker::bar, "high-res", "high-resolution camera"};
    case Source::objects:
      return {Marker::triangle, "objects", "vehicles"};
    case Source::ego_path:
      return {Marker::diamond, "other", "own path"};
    case Source::vehicle_to_vehicle:
      return {Marker::square, "other", "vehicle to vehicle"};
    case Source::user:
      break;
  }
  return {Marker::cross, "other", "own source"};
}

void draw_marker(SvgWriter& svg, Marker marker, const Pixel& at, double size, std::string_view css) {
  const auto around = [&](double x, double y) -> Pixel { return at + size * Pixel(x, y); };
  const std::string ink = fmt::format("ink-{}", css);
  switch (marker) {
    case Marker::circle:
      return svg.circle(at, size, ink);
    case Marker::square:
      return svg.polygon(std::array{around(-.9, -.9), around(.9, -.9), around(.9, .9), around(-.9, .9)}, ink);
    case Marker::triangle:
      return svg.polygon(std::array{around(0, -1.2), around(1.1, .8), around(-1.1, .8)}, ink);
    case Marker::diamond:
      return svg.polygon(std::array{around(0, -1.3), around(1.3, 0), around(0, 1.3), around(-1.3, 0)}, ink);
    case Marker::bar:
      return svg.polygon(
          std::array{around(-1.7, -.55), around(1.7, -.55), around(1.7, .55), around(-1.7, .55)}, ink);
    case Marker::cross:
      break;
  }
  const std::string pen = fmt::format("pen-{} medium", css);
  svg.line(around(-1, -1), around(1, 1), pen);
  svg.line(around(-1, 1), around(1, -1), pen);
}

}  // namespace lanefuse
