// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/map_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/pose2.hpp"
#include "drawing/axes.hpp"

namespace lanefuse {
namespace {

constexpr double kLeastExtent = 1;  // [m] so that a point has a scale too

}  // namespace

MapFrame::MapFrame(std::span<const Eigen::Vector2d> points, double width, double most_height, double angle)
    : angle_(angle), width_(width), height_(most_height) {
  Eigen::Vector2d lowest(0, 0);
  Eigen::Vector2d highest(0, 0);
  bool first = true;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d turned = rotation(angle) * point;
    lowest = first ? turned : Eigen::Vector2d(lowest.cwiseMin(turned));
    highest = first ? turned : Eigen::Vector2d(highest.cwiseMax(turned));
    first = false;
  }
  const Eigen::Vector2d extent = (highest - lowest).cwiseMax(kLeastExtent);
  pixels_per_metre_ = std::min((width - 2 * kMargin) / extent.x(), (most_height - 2 * kMargin) / extent.y());
  height_ = extent.y() * pixels_per_metre_ + 2 * kMargin;
  slack_ = (width - 2 * kMargin - extent.x() * pixels_per_metre_) / 2;
  lowest_ = lowest;
}

Pixel MapFrame::at(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d turned = (rotation(angle_) * point - lowest_) * pixels_per_metre_;
  return {kMargin + slack_ + turned.x(), height_ - kMargin - turned.y()};
}

void MapFrame::draw_scale(SvgWriter& svg) const {
  const double metres = nice_step(width_ / pixels_per_metre_, 8);
  const Pixel begin(14, height_ - 10);
  const Pixel end = begin + Pixel(metres * pixels_per_metre_, 0);
  svg.line(begin, end, "pen-text medium");
  for (const Pixel& tip : {begin, end}) svg.line(tip - Pixel(0, 4), tip + Pixel(0, 4), "pen-text medium");
  svg.text(end + Pixel(7, 4),
           metres >= 1000 ? fmt::format("{:g} km", metres / 1000) : fmt::format("{:g} m", metres),
           "label ink-text");
  const Eigen::Vector2d up = rotation(angle_) * Eigen::Vector2d(0, 1);
  const Pixel north(up.x(), -up.y());
  const Pixel across(north.y(), -north.x());
  const Pixel foot(width_ - 24, height_ - 26);
  svg.polygon(
      std::array<Pixel, 3>{foot + 13 * north, foot - 7 * north + 5 * across, foot - 7 * north - 5 * across},
      "ink-muted");
  svg.text(foot + 21 * north + Pixel(0, 4), "N", "label ink-muted", Anchor::middle);
}

double levelling_angle(std::span<const Eigen::Vector2d> points) {
  if (points.empty()) return 0;
  Eigen::Vector2d mean(0, 0);
  for (const Eigen::Vector2d& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& point : points) spread += (point - mean) * (point - mean).transpose();
  return -0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
}

}  // namespace lanefuse
