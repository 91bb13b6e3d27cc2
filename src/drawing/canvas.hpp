// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "camera/image.hpp"
#include "drawing/svg.hpp"

namespace lanefuse {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

struct Pen {
  Colour colour;
  double width = 1;       ///< [px]
  double dash = 0;        ///< [px] length of dashes and of the gaps between them; 0: solid
  bool outlined = false;  ///< with a dark rim, so that it shows on anything
};

/// Draws on pixels what SvgWriter draws as elements: for pictures that go into a video. Edges are smooth, and
/// the same calls give the same pixels.
///
/// What has no place, because a coordinate is not finite, is left out; a polyline is broken there.
class Canvas {
 public:
  Canvas(int width, int height, Colour background);

  [[nodiscard]] const Image& image() const { return image_; }
  [[nodiscard]] Box frame() const { return {0, 0, double(image_.width()), double(image_.height())}; }

  void polyline(std::span<const Pixel> points, const Pen& pen);
  void line(const Pixel& from, const Pixel& to, const Pen& pen);
  void rectangle(const Box& box, const Pen& pen);
  void fill(std::span<const Pixel> polygon, Colour colour, double opacity = 1);
  void fill(const Box& box, Colour colour, double opacity = 1);
  void disc(const Pixel& centre, double radius, Colour colour);
  /// `size` is the height of a capital letter [px]; `at` is the left (middle, right) end of its base line.
  void text(const Pixel& at, std::string_view text, Colour colour, double size,
            Anchor anchor = Anchor::start);
  /// How wide text() of that size is [px].
  static double text_width(std::string_view text, double size);

  /// `image` (three channels), scaled to fill `box`.
  void place(const ImageView& image, const Box& box);

  /// What follows, up to end_clip(), shows only inside of `box`.
  void begin_clip(const Box& box);
  void end_clip() { begin_clip(frame()); }

 private:
  Image image_;
  Box clip_;

  struct Surface;  // the part of the pixels that may be drawn on, as OpenCV takes it
  void stroke(std::span<const Pixel> points, const Pen& pen);
};

}  // namespace lanefuse
