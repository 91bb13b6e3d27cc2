// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <lanefuse/core/clothoid.hpp>
#include <lanefuse/core/pose2.hpp>

int main() {
  const lanefuse::Pose2 old_from_new = lanefuse::constant_turn(20, 0, 1);
  const lanefuse::Clothoid ahead = lanefuse::transform({.lateral_offset = 1.75}, old_from_new);
  std::printf("%.2f %.2f\n", old_from_new.x, ahead.lateral_offset);
  return 0;
}
