// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "fusion/sliding_window.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "support/window_view.hpp"

namespace lanefuse {
namespace {

using Id = SlidingWindow::Id;
using testing::EdgeKind;
using testing::WindowView;

constexpr Witness kCamera{Source::serial_camera, 1};
constexpr Witness kOtherCamera{Source::serial_camera, 2};
constexpr TieOrigin kNobody{};

Time at(double seconds) { return from_nanoseconds(0) + from_seconds(seconds); }

class Window : public ::testing::Test {
 protected:
  /// A feature that the `keyframe`-th keyframe has measured.
  Id seen(double x, double y, Time time, std::size_t keyframe = 0) {
    const Id feature = window_.add_feature({x, y, 0}, time).value();
    measure(keyframe, feature, {x, y, 0}, kCamera);
    return feature;
  }
  bool measure(std::size_t keyframe, Id feature, const Pose2& seen, const Witness& witness) {
    return window_.add_measurement(window_.graph().chain()[keyframe], feature, seen, {1, 0, 1, 1}, witness);
  }
  void tie(TieKind kind, Id from, Id to) { window_.add_tie(kind, {from, to, {0, 3, 0}}, kNobody); }
  [[nodiscard]] std::size_t edges(EdgeKind kind) const { return testing::edges_of(window_, kind).size(); }
  void prune(double seconds, const Pose2& car) { window_.prune(at(seconds), car); }

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
  const WindowView view(window_);
  for (VertexId v = 0; v < 3; ++v) EXPECT_FALSE(view.vertex(v).fixed);
  EXPECT_TRUE(view.vertex(3).fixed);
  EXPECT_EQ(view.vertex(3).pose, (Pose2{9, 0.1 * 3, 0.2}));
}

TEST_F(Window, KnowsTheKeyframeNearestInTime) {
  for (int i = 0; i < 4; ++i) window_.advance(at(i), {3.0 * i, 0, 0});
  const auto chain = window_.graph().chain();
  EXPECT_EQ(window_.nearest_keyframe(at(-5)), chain[0]);
  EXPECT_EQ(window_.nearest_keyframe(at(1.4)), chain[1]);
  EXPECT_EQ(window_.nearest_keyframe(at(1.6)), chain[2]);
  EXPECT_EQ(window_.nearest_keyframe(at(99)), chain[3]);
}

TEST_F(Window, ForgetsWhatIsBehindBeyondOrBesideTheRoad) {
  window_.advance(at(0), {});
  std::vector<Id> gone, kept;
  for (const Pose2& p : {Pose2{-5.1, 0, 0}, Pose2{160.1, 0, 0}, Pose2{10, 60.1, 0}, Pose2{10, -60.1, 0}})
    gone.push_back(seen(p.x, p.y, at(0)));
  for (const Pose2& p : {Pose2{-4.9, 0, 0}, Pose2{159.9, 0, 0}, Pose2{10, 59.9, 0}})
    kept.push_back(seen(p.x, p.y, at(0)));
  prune(1, {});
  for (const Id id : gone) EXPECT_FALSE(window_.graph().is_alive(id));
  for (const Id id : kept) EXPECT_TRUE(window_.graph().is_alive(id));
  EXPECT_EQ(window_.graph().landmark(kept[1]), (Pose2{159.9, 0, 0})) << "what stays keeps its id";
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
  const Id turned = seen(10, 0, at(0));
  window_.graph().place_landmark(turned, {10, 0, std::numeric_limits<double>::quiet_NaN()});
  prune(0.1, {});
  EXPECT_EQ(window_.feature_count(), 0U);
}

TEST_F(Window, LetsASecondLookOfASensorReplaceTheFirst) {
  window_.advance(at(0), {});
  const Id feature = seen(10, 0, at(0));
  EXPECT_FALSE(measure(0, feature, {10.5, 0, 0}, kCamera)) << "no first look";
  ASSERT_EQ(edges(EdgeKind::measurement), 1U);
  EXPECT_EQ(WindowView(window_).edge(0).measurement.x, 10.5);
  EXPECT_TRUE(measure(0, feature, {10.7, 0, 0}, kOtherCamera));
  EXPECT_EQ(edges(EdgeKind::measurement), 2U);
}

TEST_F(Window, FindsTheFirstLookBehindALateSensorsToo) {
  window_.advance(at(0), {});
  window_.advance(at(1), {3, 0, 0});
  const Id feature = seen(10, 0, at(1), 1);
  measure(0, feature, {10, 0, 0}, kOtherCamera);  // late: it belongs to the keyframe before
  measure(1, feature, {7, 0, 0}, kCamera);
  EXPECT_EQ(edges(EdgeKind::measurement), 2U);
}

TEST_F(Window, TiesTwoFeaturesOnce) {
  window_.advance(at(0), {});
  const Id a = seen(10, 0, at(0));
  const Id b = seen(20, 0, at(0));
  tie(TieKind::smoothing, a, a);
  EXPECT_EQ(edges(EdgeKind::smoothing), 0U);
  tie(TieKind::smoothing, a, b);
  tie(TieKind::smoothing, a, b);
  tie(TieKind::smoothing, b, a);
  EXPECT_EQ(edges(EdgeKind::smoothing), 1U);
  tie(TieKind::width, a, b);
  tie(TieKind::width, a, b);
  EXPECT_EQ(edges(EdgeKind::width), 1U);
  tie(TieKind::width, b, a);
  EXPECT_EQ(edges(EdgeKind::width), 2U) << "a width has a left and a right end";
  const PoseGraph graph = WindowView(window_).graph();
  ASSERT_EQ(graph.switches.size(), 1U) << "only smoothing is switched";
  EXPECT_EQ(graph.switches[0].prior, config_.switch_prior);
}

TEST_F(Window, SwitchesNothingWhereThatIsOff) {
  config_.switchable = false;
  window_.advance(at(0), {});
  const Id a = seen(10, 0, at(0));
  tie(TieKind::smoothing, a, seen(20, 0, at(0)));
  EXPECT_EQ(edges(EdgeKind::smoothing), 1U);
  EXPECT_TRUE(WindowView(window_).graph().switches.empty());
}

TEST_F(Window, IsEmptyOnceCleared) {
  window_.advance(at(0), {});
  seen(10, 0, at(0));
  window_.clear();
  EXPECT_TRUE(window_.empty());
  EXPECT_EQ(window_.feature_count(), 0U);
  EXPECT_EQ(window_.edge_count(), 0U);
  EXPECT_TRUE(WindowView(window_).graph().edges.empty());
}

}  // namespace
}  // namespace lanefuse
