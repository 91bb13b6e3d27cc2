// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/mounting_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "camera/camera_file.hpp"
#include "camera/ground_projection.hpp"
#include "camera/image_codec.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "support/files.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kWidth = 3.66;
const CameraModel kCamera({1280, 720, 1160, 1155, 667, 388, {-0.27, 0.05, 0, 0, 0}});

CameraPose pose_of(const Mounting& mounting) {
  CameraPose pose;
  pose.mounting = mounting;
  return pose;
}

/// What find_straight_road() would see of a lane whose left marking is `left` [m] beside the car.
StraightRoadView exact_view(const Mounting& mounting, double left = kWidth / 2) {
  const GroundProjection projection(kCamera, pose_of(mounting));
  StraightRoadView view;
  const auto direction = [&](double x, double y) { return kCamera.direction(*projection.pixel({x, y})); };
  for (double x = 6; x < 40; x += 0.5) {
    view.left.push_back(direction(x, left));
    view.right.push_back(direction(x, left - kWidth));
  }
  const auto slope = [](const std::vector<Eigen::Vector2d>& line) {
    const Eigen::Vector2d run = line.front() - line.back();
    return run.x() / run.y();
  };
  view.left_slope = slope(view.left);
  view.right_slope = slope(view.right);
  view.vanishing = direction(1e7, 0);
  return view;
}

/// A straight road: asphalt with grain, a yellow line on the left, white dashes on the right and one lane
/// further; grass beside it and sky above.
Image drawing_of(const Mounting& mounting, Random& random) {
  const GroundProjection projection(kCamera, pose_of(mounting));
  Image image(1280, 720, 3);
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      const double grain = random.uniform(-15, 15);
      std::array<double, 3> colour{200 + grain / 3, 160 + grain / 3, 110 + grain / 3};  // sky
      const auto ground = v > 300 ? projection.ground({u, v}) : std::nullopt;
      if (ground) {
        const double y = ground->y();
        const bool dash = std::fmod(ground->x() + 2, 12.2) < 3.7;
        const bool yellow = std::abs(y - kWidth / 2) < 0.08;
        const bool white = dash && (std::abs(y + kWidth / 2) < 0.06 || std::abs(y + 1.5 * kWidth) < 0.06);
        const bool grass = y > 4 || y < -10;
        if (yellow) {
          colour = {40, 170 + grain, 220 + grain};
        } else if (white) {
          colour = {220 + grain, 225 + grain, 225 + grain};
        } else if (grass) {
          colour = {60 + 4 * grain, 110 + 4 * grain, 120 + 4 * grain};
        } else {
          colour = {70 + grain, 70 + grain, 70 + grain};
        }
      }
      for (std::size_t c = 0; c < 3; ++c) {
        image.row(v)[3 * u + static_cast<int>(c)] =
            static_cast<std::uint8_t>(std::clamp(colour[c], 0.0, 255.0));
      }
    }
  }
  return image;
}

Mounting some_mounting(Random& random) {
  return {-0.8,
          0.1,
          random.uniform(1.1, 1.7),
          0,
          random.uniform(-3, 3) * kDegree,
          random.uniform(-3, 3) * kDegree};
}

TEST(MountingCalibration, ExactLinesGiveTheMountingExactly) {
  Random random(1, "mountings");
  for (int i = 0; i < 20; ++i) {
    const Mounting mounting = some_mounting(random);
    const std::vector<StraightRoadView> views(3, exact_view(mounting));
    const auto result = calibrate_mounting(views, kCamera, {-0.8, 0.1});
    EXPECT_EQ(result.views_used, 3);
    EXPECT_NEAR(result.mounting.z, mounting.z, 2e-3);
    EXPECT_NEAR(result.mounting.roll, 0, 0.06 * kDegree);
    EXPECT_NEAR(result.mounting.pitch, mounting.pitch, 0.02 * kDegree);
    EXPECT_NEAR(result.mounting.yaw, mounting.yaw, 0.02 * kDegree);
    EXPECT_EQ(result.mounting.x, -0.8);
    EXPECT_EQ(result.mounting.y, 0.1);
    for (const auto& view : result.views) EXPECT_LT(view.rms_px, 0.1);
  }
}

TEST(MountingCalibration, SaysWhereInItsLaneTheCarStood) {
  const Mounting mounting{0, 0, 1.3};
  const std::vector<StraightRoadView> views{exact_view(mounting, kWidth / 2 - 0.4),
                                            exact_view(mounting, kWidth / 2 + 0.4)};
  const auto result = calibrate_mounting(views, kCamera, {});
  EXPECT_NEAR(result.views[0].offset - result.views[1].offset, 0.8, 0.02);
  EXPECT_NEAR(result.mounting.z, 1.3, 0.01);
}

TEST(MountingCalibration, MoreImagesMakeAllButTheRollSurer) {
  const StraightRoadView view = exact_view({0, 0, 1.3});
  const auto few = calibrate_mounting(std::vector<StraightRoadView>(2, view), kCamera, {});
  const auto many = calibrate_mounting(std::vector<StraightRoadView>(8, view), kCamera, {});
  const auto sigma = [](const MountingCalibration& c, int i) { return std::sqrt(c.covariance(i, i)); };
  for (const int i : {0, 2, 3}) EXPECT_NEAR(sigma(many, i) / sigma(few, i), 0.5, 0.15) << i;
  EXPECT_GT(sigma(few, 1), 0.8 * kDegree);
  EXPECT_GT(sigma(many, 1), 0.6 * kDegree);
}

TEST(MountingCalibration, LeavesOutAnImageThatLooksElsewhere) {
  const Mounting mounting{0, 0, 1.3};
  Mounting turned = mounting;
  turned.yaw = 3 * kDegree;
  const std::vector<StraightRoadView> views{exact_view(mounting), exact_view(turned), exact_view(mounting)};
  const auto result = calibrate_mounting(views, kCamera, {});
  EXPECT_EQ(result.views_used, 2);
  EXPECT_FALSE(result.views[1].used);
  EXPECT_NEAR(result.mounting.yaw, 0, 0.02 * kDegree);
}

TEST(MountingCalibration, LeavesOutAnImageWithAnotherLaneWidth) {
  const Mounting mounting{0, 0, 1.3};
  const std::vector<StraightRoadView> views{exact_view(mounting), exact_view({0, 0, 1.5}),
                                            exact_view(mounting)};
  const auto result = calibrate_mounting(views, kCamera, {});
  EXPECT_FALSE(result.views[1].used);
  EXPECT_NEAR(result.mounting.z, 1.3, 2e-3);
  EXPECT_THROW(calibrate_mounting(std::span(views).first(2), kCamera, {}), Error) << "which one is right?";
}

TEST(MountingCalibration, RefusesToWorkFromNothing) {
  EXPECT_THROW(calibrate_mounting({}, kCamera, {}), Error);
}

TEST(MountingCalibration, FindsTheLinesOfDrawnRoads) {
  Random random(2, "roads");
  for (int i = 0; i < 6; ++i) {
    const Mounting mounting = some_mounting(random);
    const auto view = find_straight_road(drawing_of(mounting, random).view(), kCamera);
    ASSERT_TRUE(view) << i;
    const auto result = calibrate_mounting({&*view, 1}, kCamera, {});
    EXPECT_NEAR(result.mounting.z, mounting.z, 0.03 * mounting.z) << i;
    EXPECT_NEAR(result.mounting.pitch, mounting.pitch, 0.15 * kDegree) << i;
    EXPECT_NEAR(result.mounting.yaw, mounting.yaw, 0.15 * kDegree) << i;
  }
}

TEST(MountingCalibration, FindsNoRoadInGrain) {
  Random random(3, "grain");
  Image image(640, 360, 3);
  for (int v = 0; v < 360; ++v) {
    for (int u = 0; u < 3 * 640; ++u) image.row(v)[u] = static_cast<std::uint8_t>(random.uniform(80, 160));
  }
  EXPECT_FALSE(find_straight_road(image.view(), kCamera));
  EXPECT_FALSE(find_straight_road(Image(3, 3, 3).view(), kCamera));
}

TEST(MountingCalibration, AgreesWithWhatIsKnownOfTheRealCamera) {
  const auto folder = testing::real_data("highway_video/still");
  LANEFUSE_NEEDS_DATA(folder);
  const CameraModel camera({1280, 720, 1160, 1155, 667, 388, {-0.27, 0, 0, 0, 0}});
  std::vector<StraightRoadView> views;
  for (const char* name : {"straight_lines1.jpg", "straight_lines2.jpg"}) {
    const auto image = decode_image(testing::read_file(folder / name));
    ASSERT_TRUE(image);
    const auto view = find_straight_road(image->view(), camera);
    ASSERT_TRUE(view) << name;
    views.push_back(*view);
  }
  const auto result = calibrate_mounting(views, camera, {}, {.lane_width = kWidth});
  EXPECT_EQ(result.views_used, 2);
  EXPECT_NEAR(result.mounting.z, 1.24, 0.03 * 1.24);
  EXPECT_NEAR(result.mounting.pitch, -1.6 * kDegree, 0.3 * kDegree);
  EXPECT_NEAR(result.mounting.yaw, -1.4 * kDegree, 0.3 * kDegree) << "it looks to the right";
}

}  // namespace
}  // namespace lanefuse
