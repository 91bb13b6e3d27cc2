// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/svg.hpp"

#include <iterator>

#include <fmt/format.h>

#include "drawing/style.hpp"

namespace lanefuse {
namespace {

/// A tenth of a pixel is finer than anybody sees; "-0" and "3.0" are noise.
std::string px(double value) {
  std::string text = fmt::format("{:.1f}", value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

std::string coordinates(std::span<const Pixel> points) {
  std::string result;
  for (const Pixel& point : points) {
    if (!result.empty()) result += ' ';
    result += px(point.x()) + ',' + px(point.y());
  }
  return result;
}

const char* to_string(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
  }
  return "start";
}

std::string open_tag(const Figure& figure) {
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" class="figure" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
      R"(role="img" aria-label="{2}">)",
      px(figure.width), px(figure.height), escape_xml(figure.label));
}

}  // namespace

std::string escape_xml(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

void SvgWriter::line(const Pixel& from, const Pixel& to, std::string_view css) {
  if (!from.allFinite() || !to.allFinite()) return;
  elements_ += fmt::format(R"(<line x1="{}" y1="{}" x2="{}" y2="{}" class="{}"/>)", px(from.x()),
                           px(from.y()), px(to.x()), px(to.y()), css) +
               '\n';
}

void SvgWriter::polyline(std::span<const Pixel> points, std::string_view css) {
  for (std::size_t begin = 0; begin < points.size();) {
    std::size_t end = begin;
    while (end < points.size() && points[end].allFinite()) ++end;
    if (end > begin + 1) {
      const std::string piece = coordinates(points.subspan(begin, end - begin));
      elements_ += fmt::format(R"(<polyline points="{}" class="{}"/>)", piece, css) + '\n';
    }
    begin = end + 1;
  }
}

void SvgWriter::polygon(std::span<const Pixel> points, std::string_view css) {
  for (const Pixel& point : points) {
    if (!point.allFinite()) return;
  }
  if (points.size() < 3) return;
  elements_ += fmt::format(R"(<polygon points="{}" class="{}"/>)", coordinates(points), css) + '\n';
}

void SvgWriter::circle(const Pixel& centre, double radius, std::string_view css) {
  if (!centre.allFinite()) return;
  elements_ += fmt::format(R"(<circle cx="{}" cy="{}" r="{}" class="{}"/>)", px(centre.x()), px(centre.y()),
                           px(radius), css) +
               '\n';
}

void SvgWriter::rectangle(const Box& box, std::string_view css) {
  elements_ += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" class="{}"/>)", px(box.left),
                           px(box.top), px(box.width), px(box.height), css) +
               '\n';
}

void SvgWriter::text(const Pixel& at, std::string_view text, std::string_view css, Anchor anchor) {
  if (!at.allFinite()) return;
  elements_ += fmt::format(R"(<text x="{}" y="{}" text-anchor="{}" class="{}">{}</text>)", px(at.x()),
                           px(at.y()), to_string(anchor), css, escape_xml(text)) +
               '\n';
}

void SvgWriter::begin_clip(const Box& box) {
  elements_ += fmt::format(R"(<svg x="{0}" y="{1}" width="{2}" height="{3}" viewBox="{0} {1} {2} {3}">)",
                           px(box.left), px(box.top), px(box.width), px(box.height)) +
               '\n';
}

void SvgWriter::end_clip() { elements_ += "</svg>\n"; }

std::string standalone_svg(const Figure& figure) {
  SvgWriter background;
  background.rectangle({0, 0, figure.width, figure.height}, "ink-paper");
  return open_tag(figure) + "\n<style>" + figure_css() + "</style>\n" + background.elements() +
         figure.elements + "</svg>\n";
}

std::string inline_svg(const Figure& figure) {
  return open_tag(figure) + '\n' + figure.elements + "</svg>\n";
}

}  // namespace lanefuse
