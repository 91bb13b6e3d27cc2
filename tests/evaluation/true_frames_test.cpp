// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "evaluation/true_frames.hpp"

#include <gtest/gtest.h>

namespace lanefuse {
namespace {

Time at_ms(std::int64_t milliseconds) { return from_nanoseconds(milliseconds * 1000000); }

TrueFrame frame(std::int64_t milliseconds, double x, double speed) {
  TrueFrame result;
  result.time = at_ms(milliseconds);
  result.world_from_vehicle = {x, 5, 0};
  result.speed = speed;
  return result;
}

TEST(FrameAt, GivesTheFrameOfThatVeryTime) {
  const std::vector<TrueFrame> frames{frame(0, 0, 10), frame(100, 1, 12)};
  EXPECT_EQ(frame_at(frames, at_ms(0))->world_from_vehicle.x, 0);
  EXPECT_EQ(frame_at(frames, at_ms(100))->world_from_vehicle.x, 1);
}

TEST(FrameAt, InterpolatesPosesSpeedsAndTheObjectsThatStay) {
  std::vector<TrueFrame> frames{frame(0, 0, 10), frame(100, 1, 12)};
  frames[0].objects = {{7, {50, 3, 0}, 20}, {8, {60, 3, 0}, 20}};
  frames[1].objects = {{9, {10, 3, 0}, 20}, {7, {52, 3, 0}, 22}};
  const auto between = frame_at(frames, at_ms(25));
  ASSERT_TRUE(between);
  EXPECT_EQ(between->time, at_ms(25));
  EXPECT_NEAR(between->world_from_vehicle.x, 0.25, 1e-12);
  EXPECT_NEAR(between->speed, 10.5, 1e-12);
  ASSERT_EQ(between->objects.size(), 1U);
  EXPECT_EQ(between->objects[0].id, 7);
  EXPECT_NEAR(between->objects[0].world_from_object.x, 50.5, 1e-12);
}

TEST(FrameAt, MakesNothingUp) {
  const std::vector<TrueFrame> frames{frame(0, 0, 10), frame(1500, 20, 10)};
  EXPECT_FALSE(frame_at(frames, at_ms(-1)));
  EXPECT_FALSE(frame_at(frames, at_ms(700)));
  EXPECT_FALSE(frame_at(frames, at_ms(1501)));
  EXPECT_FALSE(frame_at({}, at_ms(0)));
}

}  // namespace
}  // namespace lanefuse
