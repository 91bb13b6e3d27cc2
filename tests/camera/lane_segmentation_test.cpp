// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_segmentation.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "camera/segmented_markings.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "support/files.hpp"
#include "support/onnx_model.hpp"

namespace lanefuse {
namespace {

using ::testing::HasSubstr;

/// Paint is whatever is brighter than half: sigmoid(20 (mean of the channels - 0.5)).
const std::array<float, 4> kBrightness{20.0F / 3, 20.0F / 3, 20.0F / 3, -10};

struct Model {
  testing::TemporaryFolder folder;
  LaneSegmentationConfig config;

  explicit Model(const std::vector<std::byte>& bytes) {
    testing::write_file(folder / "model.onnx", bytes);
    config.model = folder / "model.onnx";
  }
  Model(int width, int height) : Model(testing::pixel_network(width, height, {kBrightness}, true)) {}
};

/// Dark, with bright columns in [left, right) of the rows in [top, bottom).
Image with_patch(int left, int right, int top, int bottom) {
  Image image(64, 32, 3);
  for (int v = top; v < bottom; ++v) std::fill(image.row(v) + 3 * left, image.row(v) + 3 * right, 240);
  return image;
}

std::string refusal_of(const LaneSegmentationConfig& config) {
  try {
    LaneSegmentation segmentation(config);
    segmentation.find(with_patch(0, 1, 0, 1).view());
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::configuration);
    return error.what();
  }
  return "";
}

TEST(LaneSegmentation, FindsTheRunsOfPaint) {
  const Model model(64, 32);
  LaneSegmentation segmentation(model.config);
  const std::vector<ImageBar> runs = segmentation.find(with_patch(10, 14, 20, 23).view());
  ASSERT_EQ(runs.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(runs[i].row, 20 + i, 1e-9);
    EXPECT_NEAR(runs[i].left, 9.5, 1e-9);
    EXPECT_NEAR(runs[i].right, 13.5, 1e-9);
  }
  EXPECT_TRUE(segmentation.find(with_patch(0, 0, 0, 0).view()).empty());
  EXPECT_EQ(segmentation.find(with_patch(0, 64, 31, 32).view()).size(), 1U);
}

TEST(LaneSegmentation, AMaskOfAnotherSizeMeansPixelsOfTheImage) {
  Model model(32, 16);
  model.config.input_width = 32;
  model.config.input_height = 16;
  LaneSegmentation segmentation(model.config);
  const std::vector<ImageBar> runs = segmentation.find(with_patch(10, 14, 20, 24).view());
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_NEAR(runs[0].row, 20.5, 1e-9);
  EXPECT_NEAR(runs[0].left, 9.5, 1e-9);
  EXPECT_NEAR(runs[0].right, 13.5, 1e-9);
}

TEST(LaneSegmentation, TakesLogitsAndClasses) {
  Model logits(testing::pixel_network(64, 32, {kBrightness}, false));
  logits.config.logits = true;
  EXPECT_EQ(LaneSegmentation(logits.config).find(with_patch(10, 14, 20, 23).view()).size(), 3U);
  Model classes(testing::pixel_network(64, 32, {{0, 0, 0, 0}, kBrightness, {0, 0, 0, -1}}, false));
  EXPECT_EQ(LaneSegmentation(classes.config).find(with_patch(10, 14, 20, 23).view()).size(), 3U);
  classes.config.background_class = 1;
  EXPECT_EQ(LaneSegmentation(classes.config).find(with_patch(0, 64, 0, 31).view()).size(), 1U);
}

TEST(LaneSegmentation, HandsTheChannelsOverInOrderAndScale) {
  // Red alone, and only above 200.
  Model model(testing::pixel_network(64, 32, {{1, 0, 0, 0}}, false));
  model.config.input_mean = 200;
  model.config.input_scale = 1;
  Image image(64, 32, 3);
  image.row(3)[3 * 7 + 2] = 205;  // red
  image.row(5)[3 * 7] = 205;      // blue
  const std::vector<ImageBar> red = LaneSegmentation(model.config).find(image.view());
  ASSERT_EQ(red.size(), 1U);
  EXPECT_NEAR(red[0].row, 3, 1e-9);
  model.config.red_first = false;
  const std::vector<ImageBar> blue = LaneSegmentation(model.config).find(image.view());
  ASSERT_EQ(blue.size(), 1U);
  EXPECT_NEAR(blue[0].row, 5, 1e-9);
}

TEST(LaneSegmentation, NamesAModelThatCannotBeUsed) {
  LaneSegmentationConfig config;
  EXPECT_THAT(refusal_of(config), HasSubstr("model"));
  config.model = "/nowhere/lanes.onnx";
  EXPECT_THAT(refusal_of(config), HasSubstr("/nowhere/lanes.onnx: cannot be read"));
  const Model empty(std::vector<std::byte>{});
  EXPECT_THAT(refusal_of(empty.config), HasSubstr(empty.config.model));
  const Model text(std::vector<std::byte>(1000, std::byte{'x'}));
  EXPECT_THAT(refusal_of(text.config), HasSubstr(text.config.model));
}

TEST(LaneSegmentation, ADamagedModelIsRefusedOrWorks) {
  const std::vector<std::byte> whole = testing::pixel_network(64, 32, {kBrightness}, true);
  for (std::size_t length = 0; length < whole.size(); length += 3) {
    const Model part(
        std::vector<std::byte>(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
    EXPECT_THAT(refusal_of(part.config), HasSubstr(part.config.model)) << length;
  }
}

/// Runs of two straight lines, as a network would give them of a road seen from `pose`.
std::vector<ImageBar> runs_of_lines(const GroundProjection& projection, double heading) {
  std::vector<ImageBar> runs;
  for (int row = 250; row < 700; row += 2) {
    for (const double offset : {1.8, -1.8}) {
      const auto on_axis = projection.ground({640, row});
      if (!on_axis) continue;
      const double x = on_axis->x();
      const double y = offset + heading * x;
      const auto left = projection.pixel({x, y + 0.075});
      const auto right = projection.pixel({x, y - 0.075});
      if (left && right) runs.push_back({static_cast<double>(row), left->x(), right->x(), false});
    }
  }
  return runs;
}

CameraPose some_pose() {
  CameraPose pose;
  pose.mounting.z = 1.3;
  pose.mounting.pitch = 0.02;
  pose.covariance.diagonal() << 1e-4, 1e-5, 2e-5, 2e-5;
  return pose;
}

TEST(SegmentedMarkings, LieWhereThePaintIs) {
  const CameraModel camera({1280, 720, 1100, 1100, 639.5, 359.5, {}});
  const GroundProjection projection(camera, some_pose());
  constexpr double kHeading = 0.02;
  std::vector<ImageBar> runs = runs_of_lines(projection, kHeading);
  const LaneSegmentationConfig config;
  const std::vector<Feature> features = features_of_runs(runs, projection, config);
  ASSERT_GT(features.size(), 60U);
  for (const Feature& feature : features) {
    EXPECT_LE(feature.x, config.range_max);
    const double off_left = feature.y - 1.8 - kHeading * feature.x;
    const double off_right = feature.y + 1.8 - kHeading * feature.x;
    // A run is level in the image, not across the road.
    EXPECT_LT(std::min(std::abs(off_left), std::abs(off_right)), 0.03) << feature.x;
    EXPECT_NEAR(feature.heading, kHeading, 0.01);
    EXPECT_GT(feature.covariance.determinant(), 0);
    EXPECT_EQ(feature.confidence, config.confidence);
  }
  const auto believed =
      std::count_if(runs.begin(), runs.end(), [](const ImageBar& run) { return run.believed; });
  EXPECT_EQ(static_cast<std::size_t>(believed), features.size());
}

TEST(SegmentedMarkings, FarAwayLessIsKnown) {
  const CameraModel camera({1280, 720, 1100, 1100, 639.5, 359.5, {}});
  const GroundProjection projection(camera, some_pose());
  std::vector<ImageBar> runs = runs_of_lines(projection, 0);
  const std::vector<Feature> features = features_of_runs(runs, projection, {});
  ASSERT_FALSE(features.empty());
  EXPECT_GT(features.back().covariance(0, 0), 20 * features.front().covariance(0, 0));
  EXPECT_GT(features.back().covariance(1, 1), features.front().covariance(1, 1));
}

TEST(SegmentedMarkings, BlobsAndLoneRunsAreNoMarkings) {
  const CameraModel camera({1280, 720, 1100, 1100, 639.5, 359.5, {}});
  const GroundProjection projection(camera, some_pose());
  std::vector<ImageBar> wide;
  for (int row = 450; row < 700; ++row) wide.push_back({static_cast<double>(row), 300, 900, false});
  EXPECT_TRUE(features_of_runs(wide, projection, {}).empty());
  std::vector<ImageBar> lone{{500, 600, 615, false}};
  EXPECT_TRUE(features_of_runs(lone, projection, {}).empty());
  std::vector<ImageBar> sky{{100, 600, 615, false}, {101, 600, 615, false}};
  EXPECT_TRUE(features_of_runs(sky, projection, {}).empty());
}

}  // namespace
}  // namespace lanefuse
