// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace lanefuse {

/// A place in a picture [px], x to the right and y downwards.
using Pixel = Eigen::Vector2d;

struct Box {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
};

/// `text` as it may stand in XML and HTML, in content and in quoted attributes; control characters become
/// spaces.
std::string escape_xml(std::string_view text);

enum class Anchor { start, middle, end };

/// Writes the elements of an SVG picture, in order from back to front. Looks come from CSS classes (see
/// figure_css()), so that one picture serves light and dark pages.
///
/// What has no place, because a coordinate is not finite, is left out; a polyline is broken there.
class SvgWriter {
 public:
  void line(const Pixel& from, const Pixel& to, std::string_view css);
  void polyline(std::span<const Pixel> points, std::string_view css);
  void polygon(std::span<const Pixel> points, std::string_view css);
  void circle(const Pixel& centre, double radius, std::string_view css);
  void rectangle(const Box& box, std::string_view css);
  void text(const Pixel& at, std::string_view text, std::string_view css, Anchor anchor = Anchor::start);

  /// What follows, up to end_clip(), shows only inside of `box`.
  void begin_clip(const Box& box);
  void end_clip();

  [[nodiscard]] const std::string& elements() const { return elements_; }

 private:
  std::string elements_;
};

/// A finished picture.
struct Figure {
  double width = 0;   ///< [px]
  double height = 0;  ///< [px]
  std::string label;  ///< what it shows, for those who cannot see it
  std::string elements;
};

/// The picture as a file of its own, with its styles and a background.
std::string standalone_svg(const Figure& figure);

/// The picture as part of a page that carries figure_css().
std::string inline_svg(const Figure& figure);

}  // namespace lanefuse
