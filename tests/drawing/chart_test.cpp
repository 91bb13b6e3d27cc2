// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/chart.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/markup.hpp"

namespace lanefuse {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(NiceStep, IsARoundNumberOfAFewParts) {
  EXPECT_DOUBLE_EQ(nice_step(1, 5), 0.2);
  EXPECT_DOUBLE_EQ(nice_step(14, 8), 2);
  EXPECT_DOUBLE_EQ(nice_step(23, 10), 5);
  EXPECT_DOUBLE_EQ(nice_step(0.03, 3), 0.01);
}

RC_GTEST_PROP(NiceStep, NeverMakesMoreParts, ()) {
  const double span = *rc::gen::inRange(1, 1000000) * 1e-3;
  const int most = *rc::gen::inRange(2, 20);
  const double parts = span / nice_step(span, most);
  RC_ASSERT(parts <= most * (1 + 1e-6));
  RC_ASSERT(parts >= most / 2.6);
}

TEST(AxisFromZero, EndsAtATickAndNeverAtNothing) {
  const Axis axis = axis_from_zero("a", 0.64, 6);
  EXPECT_DOUBLE_EQ(axis.step, 0.2);
  EXPECT_DOUBLE_EQ(axis.to, 0.8);
  EXPECT_DOUBLE_EQ(axis_from_zero("a", 0, 5).to, 1);
  EXPECT_DOUBLE_EQ(axis_from_zero("a", kNan, 5).to, 1);
}

TEST(Axes, PutTheDataIntoTheFrameWithYUpwards) {
  const Axes axes({10, 20, 100, 50}, {"x", 0, 10, 1}, {"y", -1, 1, 1});
  EXPECT_EQ(axes.at(0, -1), Pixel(10, 70));
  EXPECT_EQ(axes.at(10, 1), Pixel(110, 20));
}

Chart chart_of(std::vector<Series> series) {
  return {"Title & more", {"distance [m]", 0, 120, 10}, {"RMSE [m]", 0, 1, 0.25}, std::move(series)};
}

TEST(DrawChart, HasTitleUnitsTicksAndLegend) {
  const Figure figure =
      draw_chart(chart_of({{"ego <lane>", {{0, 0.1}, {60, 0.3}}, "series-0", Marker::circle}}));
  const std::string svg = standalone_svg(figure);
  EXPECT_EQ(testing::malformed(svg), "");
  for (const char* part :
       {"Title &amp; more", "distance [m]", "RMSE [m]", "ego &lt;lane&gt;", ">120<", ">0.75<"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(testing::occurrences(svg, "<circle"), 3);  // two points and the legend
  EXPECT_EQ(svg.find("no data"), std::string::npos);
}

TEST(DrawChart, LeavesGapsWhereThereIsNoValue) {
  const Figure figure = draw_chart(
      chart_of({{"a", {{0, 0.1}, {10, 0.1}, {20, kNan}, {30, 0.1}, {40, 0.1}}, "series-0", std::nullopt}}));
  EXPECT_EQ(testing::occurrences(figure.elements, "<polyline"), 2);
  EXPECT_FALSE(testing::prints_nan(figure.elements));
}

TEST(DrawChart, SaysSoWhenThereIsNoData) {
  EXPECT_NE(draw_chart(chart_of({})).elements.find("no data"), std::string::npos);
  const Figure only_nan = draw_chart(chart_of({{"a", {{0, kNan}}, "series-0", Marker::square}}));
  EXPECT_NE(only_nan.elements.find("no data"), std::string::npos);
  EXPECT_FALSE(testing::prints_nan(only_nan.elements));
}

TEST(Percentile, IsTheNearestRank) {
  EXPECT_EQ(percentile({3}, 0.5), 3);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 1), 4);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.99), 4);
}

TEST(DrawCycleTimes, NamesThePercentilesAndPutsEveryCycleIntoABar) {
  const Figure figure = draw_cycle_times({1.0, 1.1, 1.2, 5.0});
  EXPECT_EQ(testing::malformed(standalone_svg(figure)), "");
  EXPECT_NE(figure.elements.find("p50 1.10 ms"), std::string::npos);
  EXPECT_NE(figure.elements.find("max 5.00 ms"), std::string::npos);
  EXPECT_EQ(testing::occurrences(figure.elements, "class=\"ink-series-0\""), 2);
}

TEST(DrawCycleTimes, SaysSoWhenThereAreNone) {
  EXPECT_NE(draw_cycle_times({}).elements.find("no data"), std::string::npos);
  EXPECT_FALSE(testing::prints_nan(draw_cycle_times({0.0, 0.0}).elements));
}

}  // namespace
}  // namespace lanefuse
