// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/drive_map.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "drawing/map_frame.hpp"
#include "support/markup.hpp"
#include "support/picture_scene.hpp"

namespace lanefuse {
namespace {

ErrorTrace trace_of(std::size_t cycles) {
  ErrorTrace trace;
  for (std::size_t i = 0; i < cycles; ++i) {
    const double along = 2.4 * static_cast<double>(i);
    trace.push_back({{along, 200 * std::sin(along / 900)}, i % 50 < 25 ? 0.05 : 0.9});
  }
  return trace;
}

rc::Gen<Eigen::Vector2d> places() {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(-50000, 50000), rc::gen::inRange(-50000, 50000)),
                      [](const auto& p) { return Eigen::Vector2d(p.first * 0.1, p.second * 0.1); });
}

RC_GTEST_PROP(MapFrame, HoldsEveryPlaceInOneScale, ()) {
  const auto points = *rc::gen::nonEmpty(rc::gen::container<std::vector<Eigen::Vector2d>>(places()));
  const double angle = *rc::gen::inRange(0, 628) * 0.01;
  const MapFrame map(points, 600, 400, angle);
  RC_ASSERT(map.height() <= 400 + 1e-9);
  for (const Eigen::Vector2d& point : points) {
    const Pixel pixel = map.at(point);
    RC_ASSERT(pixel.x() >= MapFrame::kMargin - 1e-6 && pixel.x() <= 600 - MapFrame::kMargin + 1e-6);
    RC_ASSERT(pixel.y() >= MapFrame::kMargin - 1e-6 && pixel.y() <= map.height() - MapFrame::kMargin + 1e-6);
  }
  const double one = (map.at(points[0] + Eigen::Vector2d(100, 0)) - map.at(points[0])).norm();
  const double other = (map.at(points[0] + Eigen::Vector2d(0, 100)) - map.at(points[0])).norm();
  RC_ASSERT(std::abs(one - other) < 1e-6 * one);
}

TEST(MapFrame, PutsNorthUp) {
  const std::vector<Eigen::Vector2d> points{{0, 0}, {100, 100}};
  const MapFrame map(points, 600, 400);
  EXPECT_LT(map.at({50, 60}).y(), map.at({50, 40}).y());
  EXPECT_GT(map.at({60, 50}).x(), map.at({40, 50}).x());
}

TEST(LevellingAngle, LaysALineFlat) {
  const std::vector<Eigen::Vector2d> points{{0, 0}, {10, 20}, {20, 40}};
  const Eigen::Vector2d turned = rotation(levelling_angle(points)) * Eigen::Vector2d(20, 40);
  EXPECT_NEAR(turned.y(), 0, 1e-9);
}

TEST(DrawDriveMap, StaysSmallHoweverLongTheDrive) {
  const Figure map = draw_drive_map(trace_of(100000));
  EXPECT_LT(map.elements.size(), 40000U);
  EXPECT_EQ(testing::malformed(standalone_svg(map)), "");
}

TEST(DrawDriveMap, TellsGoodFromBad) {
  const std::string svg = draw_drive_map(trace_of(100)).elements;
  const auto lines = [&svg](const std::string& css) {
    return testing::occurrences(svg, "class=\"" + css + " round\"");
  };
  EXPECT_EQ(lines("pen-series-4 medium"), 2);
  EXPECT_EQ(lines("pen-truth thick"), 2);
}

TEST(DrawDriveMap, ADriveThatGoesNowhereIsDrawnToo) {
  for (const ErrorTrace& trace : {ErrorTrace{}, ErrorTrace(1), ErrorTrace(30)}) {
    const Figure map = draw_drive_map(trace);
    EXPECT_EQ(testing::malformed(standalone_svg(map)), "");
    EXPECT_FALSE(testing::prints_nan(map.elements));
  }
}

TEST(DrawOnMap, ShowsEstimateTruthAndCar) {
  const std::string svg = standalone_svg(draw_on_map(testing::believable_view(), {500, -200, 2}));
  EXPECT_EQ(testing::malformed(svg), "");
  EXPECT_EQ(testing::occurrences(svg, "pen-truth medium round"), 4);
  EXPECT_EQ(testing::occurrences(svg, "<polyline"), 8);
  EXPECT_EQ(svg, standalone_svg(draw_on_map(testing::believable_view(), {500, -200, 2})));
}

}  // namespace
}  // namespace lanefuse
