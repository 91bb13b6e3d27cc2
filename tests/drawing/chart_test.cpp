// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/chart.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "drawing/evaluation_charts.hpp"
#include "support/markup.hpp"

namespace lanefuse {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

ConditionStatistics condition(double from, double to, std::uint64_t cycles) {
  ConditionStatistics result{from, to, cycles, {}};
  for (std::size_t i = 0; i < kDistanceCount; ++i) {
    DeviationStatistics at;
    at.distance_m = distance_at(i);
    at.rmse_m = 0.1;
    result.lanes.ego.push_back(at);
    result.lanes.adjacent.push_back(at);
  }
  return result;
}

TEST(ConditionChart, ShowsRangesWithEnoughCyclesAtTheirMiddle) {
  const std::vector<ConditionStatistics> counts{condition(0, 1, 500), condition(1, 3, 500),
                                                condition(3, 5, 10), condition(5, kInfinity, 500)};
  const auto points = condition_chart("t", "vehicles", counts, true).series.at(0).points;
  ASSERT_EQ(points.size(), 3U);
  EXPECT_DOUBLE_EQ(points[0].x(), 0);
  EXPECT_DOUBLE_EQ(points[1].x(), 1.5);
  EXPECT_DOUBLE_EQ(points[2].x(), 5.5);
  const auto gaps =
      condition_chart("t", "gap [m]", {condition(0, 20, 99), condition(20, kInfinity, 99)}, false);
  EXPECT_DOUBLE_EQ(gaps.series.at(0).points.at(0).x(), 10);
  EXPECT_DOUBLE_EQ(gaps.series.at(0).points.at(1).x(), 30);
  EXPECT_TRUE(condition_chart("t", "a", {}, true).series.empty());
}

}  // namespace
}  // namespace lanefuse
