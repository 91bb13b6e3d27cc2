// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "camera/image_codec.hpp"
#include "camera/marking_extractor.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

/// The mounting that the clips' straight frames give, and how well it is known in a frame.
CameraPose highway_pose() {
  constexpr double kDegree = std::numbers::pi / 180;
  CameraPose pose;
  pose.mounting = {0, 0, 1.24, 0, -1.6 * kDegree, -1.4 * kDegree};
  pose.covariance.diagonal() << 0.03 * 0.03, 9e-6, 1.6e-5, 9e-6;
  pose.vertical_curvature_sigma = 5e-5;
  return pose;
}

TEST(MarkingExtractor, FindsBothSidesOfTheLaneOnARealRoad) {
  const auto file = testing::real_data("highway_video/still/straight_lines1.jpg");
  LANEFUSE_NEEDS_DATA(file);
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const std::optional<Image> image = decode_image(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(image);
  MarkingExtractor extractor({1280, 720, 1160, 1155, 667, 388, {-0.27, 0, 0, 0, 0}});
  int left = 0;
  int right = 0;
  int between = 0;
  for (const Feature& feature : extractor.extract({image->view(), highway_pose(), {}, 0})) {
    if (feature.x > 50) continue;
    const bool yellow = feature.marking.colour == MarkingColour::yellow;
    left += yellow && feature.y > 1.4 && feature.y < 2.4;
    right += !yellow && feature.y < -1.2 && feature.y > -2.3;
    between += std::abs(feature.y) < 1;
  }
  EXPECT_GT(left, 20);  // solid and yellow
  EXPECT_GT(right, 5);  // dashes
  EXPECT_EQ(between, 0);
}

}  // namespace
}  // namespace lanefuse
