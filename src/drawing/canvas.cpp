// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace lanefuse {
namespace {

constexpr int kFraction = 4;       // bits of a pixel that OpenCV's drawing takes
constexpr double kFarOff = 20000;  // [px] OpenCV's coordinates overflow well beyond
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kCapitals = 22;  // [px] height of this font's capital letters at scale 1
constexpr Colour kRim{12, 14, 18};

cv::Scalar scalar(Colour colour) { return {double(colour.blue), double(colour.green), double(colour.red)}; }

bool has_place(const Pixel& p) { return std::abs(p.x()) < kFarOff && std::abs(p.y()) < kFarOff; }

int thickness(double width) { return std::max(1, static_cast<int>(std::lround(width))); }

/// Pieces of `points` as long as `dash`, every other one: [from, to] pairs.
std::vector<Pixel> dashes_of(std::span<const Pixel> points, double dash) {
  std::vector<Pixel> pieces;
  double walked = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Pixel step = points[i] - points[i - 1];
    const double length = step.norm();
    for (double at = 0; at < length;) {
      const double phase = std::fmod(walked + at, 2 * dash);
      const double end = std::min(length, at + (phase < dash ? dash : 2 * dash) - phase + 1e-6);
      if (phase < dash) {
        pieces.emplace_back(points[i - 1] + step * (at / length));
        pieces.emplace_back(points[i - 1] + step * (end / length));
      }
      at = end;
    }
    walked += length;
  }
  return pieces;
}

}  // namespace

/// OpenCV's drawing knows no clipping but the edge of what it draws on: this is that part of the pixels.
struct Canvas::Surface {
  cv::Mat pixels;
  Pixel corner;

  explicit Surface(Canvas& canvas) : corner(canvas.clip_.left, canvas.clip_.top) {
    Image& image = canvas.image_;
    const cv::Rect inside(int(canvas.clip_.left), int(canvas.clip_.top), int(canvas.clip_.width),
                          int(canvas.clip_.height));
    pixels = cv::Mat(image.height(), image.width(), CV_8UC3, image.row(0))(inside);
  }
  [[nodiscard]] cv::Point fine(const Pixel& p) const {
    constexpr double kScale = 1 << kFraction;
    return {static_cast<int>(std::lround((p.x() - corner.x()) * kScale)),
            static_cast<int>(std::lround((p.y() - corner.y()) * kScale))};
  }
};

Canvas::Canvas(int width, int height, Colour background) : image_(width, height, 3), clip_(frame()) {
  Surface(*this).pixels.setTo(scalar(background));
}

void Canvas::stroke(std::span<const Pixel> points, const Pen& pen) {
  const Surface surface(*this);
  std::vector<cv::Point> fine;
  const auto flush = [&] {
    if (fine.size() > 1) {
      cv::polylines(surface.pixels, fine, false, scalar(pen.colour), thickness(pen.width), cv::LINE_AA,
                    kFraction);
    }
    fine.clear();
  };
  for (const Pixel& point : points) {
    if (has_place(point)) {
      fine.push_back(surface.fine(point));
    } else {
      flush();
    }
  }
  flush();
}

void Canvas::polyline(std::span<const Pixel> points, const Pen& pen) {
  if (!std::all_of(points.begin(), points.end(), has_place)) {
    const auto gap = std::find_if_not(points.begin(), points.end(), has_place);
    const auto here = static_cast<std::size_t>(gap - points.begin());
    polyline(points.first(here), pen);
    return polyline(points.subspan(here + 1), pen);
  }
  if (pen.outlined) polyline(points, {kRim, pen.width + 2, pen.dash});
  if (pen.dash <= 0) return stroke(points, pen);
  const std::vector<Pixel> pieces = dashes_of(points, pen.dash);
  for (std::size_t i = 0; i + 1 < pieces.size(); i += 2) stroke(std::span(pieces).subspan(i, 2), pen);
}

void Canvas::line(const Pixel& from, const Pixel& to, const Pen& pen) { polyline(std::array{from, to}, pen); }

void Canvas::rectangle(const Box& box, const Pen& pen) {
  const Pixel a(box.left, box.top), b(box.right(), box.top), c(box.right(), box.bottom()),
      d(box.left, box.bottom());
  polyline(std::array{a, b, c, d, a}, pen);
}

void Canvas::fill(std::span<const Pixel> polygon, Colour colour, double opacity) {
  if (polygon.size() < 3 || !std::all_of(polygon.begin(), polygon.end(), has_place)) return;
  const Surface surface(*this);
  std::vector<cv::Point> fine;
  for (const Pixel& point : polygon) fine.push_back(surface.fine(point));
  if (opacity >= 1) return cv::fillPoly(surface.pixels, fine, scalar(colour), cv::LINE_AA, kFraction);
  cv::Rect inside = cv::boundingRect(fine);
  inside = cv::Rect(inside.x >> kFraction, inside.y >> kFraction, (inside.width >> kFraction) + 2,
                    (inside.height >> kFraction) + 2) &
           cv::Rect({}, surface.pixels.size());
  if (inside.empty()) return;
  cv::Mat below = surface.pixels(inside);
  cv::Mat above = below.clone();
  for (cv::Point& point : fine) point -= inside.tl() * (1 << kFraction);
  cv::fillPoly(above, fine, scalar(colour), cv::LINE_AA, kFraction);
  cv::addWeighted(above, opacity, below, 1 - opacity, 0, below);
}

void Canvas::fill(const Box& box, Colour colour, double opacity) {
  fill(std::array{Pixel(box.left, box.top), Pixel(box.right(), box.top), Pixel(box.right(), box.bottom()),
                  Pixel(box.left, box.bottom())},
       colour, opacity);
}

void Canvas::disc(const Pixel& centre, double radius, Colour colour) {
  if (!has_place(centre)) return;
  const Surface surface(*this);
  cv::circle(surface.pixels, surface.fine(centre), int(std::lround(radius * (1 << kFraction))),
             scalar(colour), cv::FILLED, cv::LINE_AA, kFraction);
}

double Canvas::text_width(std::string_view text, double size) {
  int base_line = 0;
  return cv::getTextSize(std::string(text), kFont, size / kCapitals, thickness(size / 10), &base_line).width;
}

void Canvas::text(const Pixel& at, std::string_view text, Colour colour, double size, Anchor anchor) {
  if (!has_place(at)) return;
  const Surface surface(*this);
  const double width = anchor == Anchor::start ? 0 : text_width(text, size);
  const double left = at.x() - surface.corner.x() - (anchor == Anchor::middle ? width / 2 : width);
  cv::putText(surface.pixels, std::string(text),
              {int(std::lround(left)), int(std::lround(at.y() - surface.corner.y()))}, kFont,
              size / kCapitals, scalar(colour), thickness(size / 10), cv::LINE_AA);
}

void Canvas::place(const ImageView& image, const Box& box) {
  if (image.empty() || image.channels != 3) return;
  const cv::Mat from(image.height, image.width, CV_8UC3,
                     const_cast<std::uint8_t*>(image.data),  // NOLINT: it is only read
                     static_cast<std::size_t>(image.stride));
  cv::Mat scaled;
  const cv::Size size(int(box.width), int(box.height));
  cv::resize(from, scaled, size, 0, 0, size.width < image.width ? cv::INTER_AREA : cv::INTER_LINEAR);
  cv::Mat all(image_.height(), image_.width(), CV_8UC3, image_.row(0));
  const cv::Rect there(int(box.left), int(box.top), size.width, size.height);
  const cv::Rect seen = there & cv::Rect({}, all.size());
  if (!seen.empty()) scaled(seen - there.tl()).copyTo(all(seen));
}

void Canvas::begin_clip(const Box& box) {
  const Box all = frame();
  const double left = std::clamp(std::floor(box.left), 0.0, all.width - 1);
  const double top = std::clamp(std::floor(box.top), 0.0, all.height - 1);
  clip_ = {left, top, std::clamp(std::ceil(box.right()), left + 1, all.width) - left,
           std::clamp(std::ceil(box.bottom()), top + 1, all.height) - top};
}

}  // namespace lanefuse
