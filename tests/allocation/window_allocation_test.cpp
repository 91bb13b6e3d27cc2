// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// What is said to allocate nothing does not: every operator new of this program is counted.
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "allocation/steady_drive.hpp"
#include "fusion/feature_fusion.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t bytes, std::size_t alignment) {
  ++allocations;
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole > 0 ? whole : alignment);
  if (!memory) throw std::bad_alloc();
  return memory;
}

constexpr std::size_t kDefault = alignof(std::max_align_t);

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, kDefault); }
void* operator new[](std::size_t bytes) { return counted(bytes, kDefault); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace lanefuse {

std::size_t testing::allocations() { return ::allocations; }

namespace {

using Id = WindowGraph::Id;
using testing::Count;

TEST(Counting, SeesWhatVectorsTake) {
  const Count count;
  std::vector<double> numbers(7);
  const Quads quads(3);
  EXPECT_EQ(count(), 2U);
}

TEST(WindowGraph, AllocatesNothingWithinItsLimits) {
  WindowGraph::Limits limits;
  limits.poses = 20;
  limits.landmarks = 100;
  limits.observations = 400;
  limits.ties = 99;
  WindowGraph graph(limits);
  const Count count;
  for (int round = 0; round < 3; ++round) {
    for (int p = 0; p < 20; ++p) graph.append_pose({2.0 * p, 0, 0}, {2, 0, 0}, Eigen::Matrix3d::Identity());
    Id previous = WindowGraph::kNone;
    // Most landmarks have a block of four for one observation.
    for (int l = 0; l < 100; ++l) {
      const Id id = graph.add_landmark({1.0 * l, 2, 0});
      const std::size_t looks = l < 80 ? 1 : 16;
      for (std::size_t k = 0; k < looks; ++k)
        graph.observe(graph.chain()[k], id, {1.0 * l, 2, 0}, {1, 0, 10, 100}, 1);
      WindowGraph::Tie tie;
      tie.from = std::exchange(previous, id);
      tie.to = id;
      if (l > 0) graph.add_tie(tie, Eigen::Matrix3d::Identity(), true);
    }
    ASSERT_EQ(graph.observation_count(), 400U);
    if (round == 1) {
      graph.clear();
      continue;
    }
    for (Id id = 0; id < 100; ++id) graph.remove_landmark(id);
    while (graph.chain().size() > 1) graph.remove_pose(0);
    if (round == 0) graph.clear();
  }
  EXPECT_EQ(count(), 0U);
}

/// A window of a steady drive: four markings and two tracked vehicles, seen again and again.
class SteadyWindow {
 public:
  SteadyWindow() { pairs_.reserve(400); }

  void advance() {
    const double car = 1.2 * cycle_++;
    now_ += from_seconds(0.04);
    window_.advance(now_, {car, 0, 0});
    window_.prune(now_, {car, 0, 0});
    std::erase_if(pairs_, [&](const Pair& p) {
      return !window_.graph().is_alive(p.left) || !window_.graph().is_alive(p.right);
    });
    if (cycle_ % 2 == 0) add_pair(car + 50);
    for (const Pair& pair : pairs_) measure(pair, car);
  }

  SolveResult solve(WindowSolver& solver) { return solver.solve(window_.graph(), {}); }
  [[nodiscard]] const SlidingWindow& window() const { return window_; }

 private:
  struct Pair {
    Id left, right;
    double x;
  };

  void add_pair(double x) {
    const auto left = window_.add_feature({x, 1.75, 0}, now_);
    const auto right = window_.add_feature({x, -1.75, 0}, now_);
    ASSERT_TRUE(left && right);
    const Eigen::Matrix3d information = Eigen::Vector3d(0, 100, 1000).asDiagonal();
    window_.add_tie(TieKind::width, {*right, *left, {0, 3.5, 0}, information}, {7, Side::none});
    if (!pairs_.empty()) {
      const Pair& last = pairs_.back();
      window_.add_tie(TieKind::smoothing, {last.left, *left, {}, information}, {7, Side::left});
      window_.add_tie(TieKind::smoothing, {last.right, *right, {}, information}, {7, Side::right});
    }
    pairs_.push_back({*left, *right, x});
  }

  void measure(const Pair& pair, double car) {
    const Id keyframe = window_.nearest_keyframe(now_);
    const double noise = 0.02 * std::sin(37.0 * pair.x + cycle_ % 5);
    const double ahead = pair.x - window_.keyframe(keyframe).odometry_from_vehicle.x;
    if (pair.x - car < 0) return;
    window_.add_measurement(keyframe, pair.left, {ahead, 1.75 + noise, 0.001}, {1, 0, 100, 1000},
                            {Source::serial_camera, 1});
    window_.add_measurement(keyframe, pair.right, {ahead, -1.75 - noise, -0.001}, {1, 0, 100, 1000},
                            {Source::serial_camera, 1});
  }

  FusionConfig config_;
  SlidingWindow window_{config_};
  std::vector<Pair> pairs_;
  Time now_{};
  int cycle_ = 0;
};

TEST(ConjugateGradientSolver, AllocatesNothingInSteadyState) {
  SteadyWindow steady;
  ConjugateGradientSolver solver;
  for (int cycle = 0; cycle < 200; ++cycle) {
    steady.advance();
    ASSERT_TRUE(steady.solve(solver).ok());
  }
  ASSERT_GT(steady.window().feature_count(), 40U);
  ASSERT_GT(steady.window().graph().tie_count(), 60U);
  std::size_t of_window = 0;
  std::size_t of_solver = 0;
  for (int cycle = 0; cycle < 500; ++cycle) {
    const Count while_advancing;
    steady.advance();
    of_window += while_advancing();
    const Count while_solving;
    const SolveResult result = steady.solve(solver);
    of_solver += while_solving();
    ASSERT_EQ(result.fallback, SolveFallback::none);
    ASSERT_GT(result.cg_iterations, 0) << "there is something to solve";
  }
  EXPECT_EQ(of_window, 0U);
  EXPECT_EQ(of_solver, 0U);
}

TEST(FeatureFusion, AllocatesNothingInSteadyState) {
  const FusionConfig config;
  FeatureFusion fusion(config, std::make_unique<ConjugateGradientSolver>());
  const LaneEstimator::StageListener nobody = [](Stage) {};
  std::vector<MotionSample> motion;
  std::size_t count_of_all = 0;
  for (int cycle = 0; cycle < 700; ++cycle) {
    const Time now = from_nanoseconds(1'000'000'000) + cycle * std::chrono::milliseconds(40);
    motion.push_back({now, {1.2 * cycle, 0, 0}, 0, 0});
    const std::vector<FeatureSet> sets = testing::sets_at(cycle, now);
    const Cycle input{now, motion, sets};
    const Count count;
    const FusionResult result = fusion.process(input, nobody);
    if (cycle >= 300) count_of_all += count();
    ASSERT_TRUE(result.solve.ok());
  }
  EXPECT_GT(fusion.fused().size(), 50U);
  EXPECT_GT(fusion.window().graph().tie_count(), 20U);
  EXPECT_EQ(count_of_all, 0U);
}

}  // namespace
}  // namespace lanefuse
