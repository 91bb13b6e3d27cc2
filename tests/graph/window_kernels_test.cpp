// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernels of this processor and the plain ones, run side by side on random systems: the same bytes.
#include "graph/window_kernels.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include "graph/random_window.hpp"

namespace lanefuse {
namespace {

using testing::WindowMaker;

class Kernels : public ::testing::TestWithParam<unsigned> {
 protected:
  Kernels() {
    if (&window_kernels() == &plain_kernels()) return;
    for (WindowGraph::Id id = 0; id < graph_.landmark_slots(); ++id) {
      const std::uint32_t begin = system_.runs.empty() ? 0 : system_.runs.back().end;
      system_.runs.push_back({id, begin, begin + (graph_.observation_count(id) + 3) / 4});
      const Pose2 l = graph_.landmark(id);
      system_.landmarks.push_back(Quad{l.x, l.y, l.heading, 0});
    }
    const std::size_t blocks = system_.runs.empty() ? 0 : system_.runs.back().end;
    system_.untied = system_.runs.size() / 2;
    system_.linear.resize(blocks);
    system_.scratch.resize(3 * blocks);
    for (auto* by_landmark : {&system_.information, &system_.landmark_rhs})
      by_landmark->resize(system_.runs.size());
    system_.inverses = any(system_.runs.size());
    for (auto* by_pose :
         {&system_.places, &system_.turns, &system_.pose_rhs, &system_.reduced_first, &system_.reduced_rest})
      by_pose->assign(graph_.pose_slots(), Quad{});
    for (const WindowGraph::Id id : graph_.chain()) {
      const Pose2 p = graph_.pose(id);
      system_.places[id] = Quad{p.x, p.y, p.heading, 0};
      system_.turns[id] =
          Quad{std::cos(p.heading), std::sin(p.heading), std::cos(2 * p.heading), std::sin(2 * p.heading)};
    }
  }

  void SetUp() override {
    if (&window_kernels() == &plain_kernels()) GTEST_SKIP() << "this processor has the plain ones only";
  }

  Quads any(std::size_t count) {
    Quads result(count);
    for (Quad& q : result) {
      for (int i = 0; i < 4; ++i) q[i] = maker_.uniform(-2, 2);
    }
    return result;
  }

  WindowMaker maker_{testing::any_shape(GetParam())};
  WindowGraph graph_ = maker_.make();
  WindowSystem system_;
};

template <typename Vector>
void expect_same_bytes(const Vector& a, const Vector& b) {
  ASSERT_EQ(a.size(), b.size());
  if (!a.empty()) {
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])), 0);
  }
}

void expect_same_bytes(const WindowSystem& a, const WindowSystem& b) {
  for (const auto vectors :
       {&WindowSystem::scratch, &WindowSystem::information, &WindowSystem::landmark_rhs,
        &WindowSystem::pose_rhs, &WindowSystem::reduced_first, &WindowSystem::reduced_rest})
    expect_same_bytes(a.*vectors, b.*vectors);
  ASSERT_EQ(a.linear.size(), b.linear.size());
  for (std::size_t i = 0; i < a.linear.size(); ++i) {
    for (const auto quad : {&LinearBlock::xx, &LinearBlock::xy, &LinearBlock::yy, &LinearBlock::heading,
                            &LinearBlock::ux, &LinearBlock::uy})
      EXPECT_EQ(std::memcmp(&(a.linear[i].*quad), &(b.linear[i].*quad), sizeof(Quad)), 0);
    EXPECT_EQ(a.linear[i].pose, b.linear[i].pose);
  }
}

TEST_P(Kernels, GiveTheSameBytesOnEveryProcessor) {
  WindowSystem plain = system_;
  WindowSystem own = system_;
  const std::size_t begin = system_.untied;
  const std::size_t end = system_.runs.size();
  const double plain_cost = plain_kernels().linearize(graph_, plain);
  EXPECT_EQ(plain_cost, window_kernels().linearize(graph_, own));
  expect_same_bytes(plain, own);
  EXPECT_EQ(plain_kernels().cost(graph_, plain), window_kernels().cost(graph_, own));
  EXPECT_NEAR(plain_kernels().cost(graph_, plain), plain_cost, 1e-12 * plain_cost);
  plain_kernels().reduce_diagonal(plain);
  window_kernels().reduce_diagonal(own);
  expect_same_bytes(plain, own);

  const Quads by_landmark = any(end);
  const Quads by_pose = any(graph_.pose_slots());
  Quads plain_poses = by_pose, own_poses = by_pose;
  plain_kernels().spread(plain, begin, end, by_landmark, plain_poses);
  window_kernels().spread(own, begin, end, by_landmark, own_poses);
  expect_same_bytes(plain_poses, own_poses);
  Quads plain_landmarks = by_landmark, own_landmarks = by_landmark;
  plain_kernels().gather(plain, begin, end, by_pose, plain_landmarks);
  window_kernels().gather(own, begin, end, by_pose, own_landmarks);
  expect_same_bytes(plain_landmarks, own_landmarks);
  plain_kernels().product(plain, by_pose, plain_landmarks, plain_poses);
  window_kernels().product(own, by_pose, own_landmarks, own_poses);
  expect_same_bytes(plain_landmarks, own_landmarks);
  expect_same_bytes(plain_poses, own_poses);
  plain_kernels().rest(plain, begin, end, by_pose, by_landmark, plain_poses);
  window_kernels().rest(own, begin, end, by_pose, by_landmark, own_poses);
  expect_same_bytes(plain_poses, own_poses);
  expect_same_bytes(plain, own);
}

INSTANTIATE_TEST_SUITE_P(AnyWindow, Kernels, ::testing::Range(0U, 20U));

}  // namespace
}  // namespace lanefuse
