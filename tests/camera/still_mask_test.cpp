// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/still_mask.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lanefuse {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 160;

/// A road with a reflection that stands still at column 100, and a line that sways around column 200.
Image picture(Random& random) {
  Image image(kWidth, kHeight, 3);
  const int line = 200 + static_cast<int>(std::lround(random.normal(6)));
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool bright = (u >= 100 && u < 110) || (u >= line && u < line + 10);
      for (int c = 0; c < 3; ++c) {
        image.row(v)[3 * u + c] = static_cast<std::uint8_t>(80 + random.normal(3) + (bright ? 40 : 0));
      }
    }
  }
  return image;
}

TEST(StillMask, LearnsWhatStandsStillButNotTheLine) {
  Random random(1, "pictures");
  StillMask mask(kWidth, kHeight);
  for (int i = 0; i < 300; ++i) {
    if (i == 60) {
      EXPECT_FALSE(mask.is_still(120, 99.5, 109.5)) << "too early to know";
    }
    mask.learn(picture(random).view(), 2.4);
  }
  for (const int row : {60, 100, 130, 150}) {
    EXPECT_TRUE(mask.is_still(row, 99.5, 109.5)) << row;
    EXPECT_FALSE(mask.is_still(row, 199.5, 209.5)) << row;
    EXPECT_FALSE(mask.is_still(row, 49.5, 59.5)) << row;
  }
  mask.reset();
  EXPECT_FALSE(mask.is_still(120, 99.5, 109.5));
}

TEST(StillMask, LearnsNothingWhileTheCarStands) {
  Random random(1, "pictures");
  StillMask mask(kWidth, kHeight);
  const Image image = picture(random);
  for (int i = 0; i < 300; ++i) mask.learn(image.view(), 0);
  EXPECT_FALSE(mask.is_still(120, 99.5, 109.5));
}

}  // namespace
}  // namespace lanefuse
