// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/graph_view.hpp"

#include <gtest/gtest.h>

#include "support/markup.hpp"
#include "support/picture_scene.hpp"

namespace lanefuse {
namespace {

TEST(GraphView, DrawsEachEdgeOnceAndNamesEachKindOnce) {
  const GraphView view = testing::lane_change_graph();
  const std::string svg = draw_graph(view).elements;
  EXPECT_EQ(testing::malformed(standalone_svg(draw_graph(view))), "");
  EXPECT_EQ(testing::occurrences(svg, "pen-truth thick dashed"), 2 + 1);  // two edges off, and the legend
  for (const char* kind :
       {">pose<", ">odometry<", ">width<", ">smoothing<", ">measurement<", ">switched off<"}) {
    EXPECT_EQ(testing::occurrences(svg, kind), 1) << kind;
  }
  EXPECT_EQ(testing::occurrences(svg, ">x3<"), 1);
}

TEST(GraphView, SaysSoWhenItIsEmpty) {
  const Figure figure = draw_graph({});
  EXPECT_NE(figure.elements.find("no data"), std::string::npos);
  EXPECT_FALSE(testing::prints_nan(figure.elements));
}

TEST(GraphView, OneNodeAloneHasRoomAroundIt) {
  GraphView view;
  view.nodes.push_back({3, 4, "x0", "pose", 0.5});
  EXPECT_FALSE(testing::prints_nan(draw_graph(view).elements));
  EXPECT_EQ(testing::malformed(standalone_svg(draw_graph(view))), "");
}

}  // namespace
}  // namespace lanefuse
