// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/sliding_window.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "support/fusion_drive.hpp"

namespace lanefuse {
namespace {

constexpr EdgeOrigin kCamera{EdgeKind::measurement, Source::serial_camera, 1};
constexpr EdgeOrigin kOtherCamera{EdgeKind::measurement, Source::serial_camera, 2};
constexpr EdgeOrigin kSmoothing{EdgeKind::smoothing, Source::objects};
constexpr EdgeOrigin kWidth{EdgeKind::width, Source::objects};

Time at(double seconds) { return from_nanoseconds(0) + from_seconds(seconds); }

class Window : public ::testing::Test {
 protected:
  VertexId seen(double x, double y, Time time, VertexId keyframe = 0) {
    const VertexId feature = window_.add_feature({x, y, 0}, time);
    window_.add_measurement({keyframe, feature, {x, y, 0}}, kCamera);
    return feature;
  }
  std::size_t edges(EdgeKind kind) const { return testing::edges_of(window_, kind).size(); }
  const std::vector<VertexId>& prune(double seconds, const Pose2& car) {
    return window_.prune(at(seconds), car);
  }

  FusionConfig config_;
  SlidingWindow window_{config_};
};

TEST_F(Window, TakesAKeyframeADistance) {
  for (int i = 0; i <= 10; ++i) window_.advance(at(0.1 * i), {0.5 * i, 0, 0});
  EXPECT_EQ(window_.keyframe_count(), 3U);  // at 0, 2 and 4 m
  EXPECT_EQ(edges(EdgeKind::odometry), 2U);
  for (int i = 11; i < 100; ++i) window_.advance(at(0.1 * i), {5, 0, 0.01 * i});
  EXPECT_EQ(window_.keyframe_count(), 3U) << "a car that stands takes none";
}

TEST_F(Window, HoldsItsNewestKeyframeAlone) {
  for (int i = 0; i < 4; ++i) window_.advance(at(i), {3.0 * i, 0.1 * i, 0.2});
  const auto& vertices = window_.graph().vertices;
  for (VertexId id = 0; id < 3; ++id) EXPECT_FALSE(vertices[id].fixed);
  EXPECT_TRUE(vertices[3].fixed);
  EXPECT_EQ(vertices[3].pose, (Pose2{9, 0.1 * 3, 0.2}));
}

TEST_F(Window, KnowsTheKeyframeNearestInTime) {
  for (int i = 0; i < 4; ++i) window_.advance(at(i), {3.0 * i, 0, 0});
  EXPECT_EQ(window_.nearest_keyframe(at(-5)), 0U);
  EXPECT_EQ(window_.nearest_keyframe(at(1.4)), 1U);
  EXPECT_EQ(window_.nearest_keyframe(at(1.6)), 2U);
  EXPECT_EQ(window_.nearest_keyframe(at(99)), 3U);
}

TEST_F(Window, ForgetsWhatIsBehindBeyondOrBesideTheRoad) {
  window_.advance(at(0), {});
  for (const Pose2& gone : {Pose2{-5.1, 0, 0}, Pose2{160.1, 0, 0}, Pose2{10, 60.1, 0}, Pose2{10, -60.1, 0}}) {
    seen(gone.x, gone.y, at(0));
  }
  for (const Pose2& kept : {Pose2{-4.9, 0, 0}, Pose2{159.9, 0, 0}, Pose2{10, 59.9, 0}})
    seen(kept.x, kept.y, at(0));
  const auto& ids = prune(1, {});
  EXPECT_EQ(ids, (std::vector<VertexId>{0, SlidingWindow::kForgotten, SlidingWindow::kForgotten,
                                        SlidingWindow::kForgotten, SlidingWindow::kForgotten, 1, 2, 3}));
  EXPECT_EQ(edges(EdgeKind::measurement), 3U);
}

TEST_F(Window, LooksFromWhereTheCarIsAndWhereItHeads) {
  window_.advance(at(0), {});
  seen(100, 20, at(0));
  prune(1, {100, 0, 1.5});
  EXPECT_EQ(window_.feature_count(), 1U);
  prune(1, {100, 0, -1.5});
  EXPECT_EQ(window_.feature_count(), 0U);
}

TEST_F(Window, ForgetsWhatNobodyHasMeasuredForLong) {
  window_.advance(at(0), {});
  seen(10, 0, at(0));
  seen(20, 0, at(5));
  prune(60, {});
  EXPECT_EQ(window_.feature_count(), 2U);
  prune(60.1, {});
  EXPECT_EQ(window_.feature_count(), 1U);
}

TEST_F(Window, ForgetsWhatIsNowhere) {
  window_.advance(at(0), {});
  seen(std::numeric_limits<double>::quiet_NaN(), 0, at(0));
  const VertexId turned = seen(10, 0, at(0));
  window_.graph().vertices[turned].pose.heading = std::numeric_limits<double>::quiet_NaN();
  prune(0.1, {});
  EXPECT_EQ(window_.feature_count(), 0U);
}

TEST_F(Window, LetsASecondLookOfASensorReplaceTheFirst) {
  window_.advance(at(0), {});
  const VertexId feature = seen(10, 0, at(0));
  window_.add_measurement({0, feature, {10.5, 0, 0}}, kCamera);
  ASSERT_EQ(edges(EdgeKind::measurement), 1U);
  EXPECT_EQ(window_.graph().edges[0].measurement.x, 10.5);
  window_.add_measurement({0, feature, {10.7, 0, 0}}, kOtherCamera);
  EXPECT_EQ(edges(EdgeKind::measurement), 2U);
}

TEST_F(Window, FindsTheFirstLookBehindALateSensorsToo) {
  window_.advance(at(0), {});
  window_.advance(at(1), {3, 0, 0});
  const VertexId feature = seen(10, 0, at(1), 1);
  window_.add_measurement({0, feature, {10, 0, 0}}, kOtherCamera);  // late: it belongs to the keyframe before
  window_.add_measurement({1, feature, {7, 0, 0}}, kCamera);
  EXPECT_EQ(edges(EdgeKind::measurement), 2U);
}

TEST_F(Window, TiesTwoFeaturesOnce) {
  window_.advance(at(0), {});
  const VertexId a = seen(10, 0, at(0));
  const VertexId b = seen(20, 0, at(0));
  window_.add_tie({a, a, {}}, kSmoothing);
  EXPECT_EQ(edges(EdgeKind::smoothing), 0U);
  window_.add_tie({a, b, {}}, kSmoothing);
  window_.add_tie({a, b, {}}, kSmoothing);
  window_.add_tie({b, a, {}}, kSmoothing);
  EXPECT_EQ(edges(EdgeKind::smoothing), 1U);
  window_.add_tie({a, b, {0, 3, 0}}, kWidth);
  window_.add_tie({a, b, {0, 3, 0}}, kWidth);
  EXPECT_EQ(edges(EdgeKind::width), 1U);
  EXPECT_EQ(window_.graph().switches.size(), 1U) << "only smoothing is switched";
  EXPECT_EQ(window_.graph().switches[0].prior, config_.switch_prior);
}

TEST_F(Window, SwitchesNothingWhereThatIsOff) {
  config_.switchable = false;
  window_.advance(at(0), {});
  window_.add_tie({seen(10, 0, at(0)), seen(20, 0, at(0)), {}}, kSmoothing);
  EXPECT_EQ(edges(EdgeKind::smoothing), 1U);
  EXPECT_TRUE(window_.graph().switches.empty());
}

TEST_F(Window, IsEmptyOnceCleared) {
  window_.advance(at(0), {});
  seen(10, 0, at(0));
  window_.clear();
  EXPECT_TRUE(window_.empty());
  EXPECT_EQ(window_.feature_count(), 0U);
  EXPECT_TRUE(window_.graph().edges.empty());
}

}  // namespace
}  // namespace lanefuse
