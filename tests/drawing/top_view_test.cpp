// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/top_view.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "support/markup.hpp"
#include "support/picture_scene.hpp"

namespace lanefuse {
namespace {

using testing::believable_view;
using testing::occurrences;

TEST(TopView, IsWellFormedAndStandsAlone) {
  const std::string svg = standalone_svg(draw_top_view(believable_view()));
  EXPECT_EQ(testing::malformed(svg), "");
  EXPECT_FALSE(testing::prints_nan(svg));
  EXPECT_TRUE(testing::addresses(svg).empty());
  EXPECT_EQ(svg, standalone_svg(draw_top_view(believable_view())));
}

TEST(TopView, ShowsWhichEdgesAreOffAndWhichFeaturesAreOutliers) {
  const TopView view = believable_view();
  const std::string svg = draw_top_view(view).elements;
  EXPECT_EQ(occurrences(svg, "pen-truth thick dashed"), 2 + 1);  // two edges and the legend
  const auto outliers = std::count_if(view.debug.features.begin(), view.debug.features.end(),
                                      [](const FusedFeature& fused) { return fused.outlier; });
  ASSERT_GT(outliers, 0);
  EXPECT_EQ(occurrences(svg, "ink-outlier"), outliers + 1);
}

TEST(TopView, TheLegendNamesOnlyWhatIsThere) {
  TopView view = believable_view();
  const std::string everything = draw_top_view(view).elements;
  for (const char* label : {"truth", "base clothoid", "serial camera", "high-resolution camera", "vehicles",
                            "outlier", "smoothing edge", "switched off", "boundary, with 1 sigma"}) {
    EXPECT_NE(everything.find(label), std::string::npos) << label;
  }
  view.debug = {};
  view.true_boundaries.clear();
  const std::string lanes_only = draw_top_view(view).elements;
  for (const char* label : {">truth", "base clothoid", "camera", "outlier", "edge", "switched off"}) {
    EXPECT_EQ(lanes_only.find(label), std::string::npos) << label;
  }
}

TEST(TopView, ShowsThePathDrivenLater) {
  TopView view = believable_view();
  view.driven_path = {{0, 0}, {60, 1}, {120, 3}};
  EXPECT_NE(draw_top_view(view).elements.find("path driven later"), std::string::npos);
}

TEST(TopView, AnEmptyMomentStillSaysItsStatus) {
  const Figure figure = draw_top_view({});
  EXPECT_EQ(testing::malformed(standalone_svg(figure)), "");
  EXPECT_NE(figure.elements.find("status INVALID (warming_up)"), std::string::npos);
}

TEST(TopView, SurvivesAnEstimateGoneWild) {
  TopView view = believable_view();
  view.estimate.boundaries[0].clothoid.lateral_offset = std::numeric_limits<double>::quiet_NaN();
  view.estimate.boundaries[1].clothoid.curvature = 1e6;
  for (Boundary& boundary : view.estimate.boundaries) sample_points(boundary);
  view.debug.features[0].feature.y = std::numeric_limits<double>::infinity();
  const std::string svg = standalone_svg(draw_top_view(view));
  EXPECT_EQ(testing::malformed(svg), "");
  EXPECT_FALSE(testing::prints_nan(svg));
}

TEST(TopView, EscapesItsTitle) {
  TopView view;
  view.title = "<script>alert('&')</script>";
  EXPECT_EQ(testing::malformed(standalone_svg(draw_top_view(view))), "");
}

TEST(BoundariesInView, AreThoseAroundTheCar) {
  const testing::RoadScene scene;
  const auto lines = boundaries_in_view(testing::true_road(scene), scene.world_from_vehicle);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_LT(lines[0].front().x(), -25);
  EXPECT_GT(lines[0].back().x(), 130);
  Pose2 far_away = scene.world_from_vehicle;
  far_away.x += 5000;
  for (const auto& line : boundaries_in_view(testing::true_road(scene), far_away))
    EXPECT_LT(line.back().x(), 0);
}

}  // namespace
}  // namespace lanefuse
