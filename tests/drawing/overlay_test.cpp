// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "camera/ground_projection.hpp"
#include "drawing/overlay_colours.hpp"
#include "support/road_scene.hpp"

namespace lanefuse {
namespace {

constexpr double kImageTop = 60;  // [px] of the image in the picture: below the words

/// A grey image as wide as the picture, so that its pixels are the picture's, and a road that a run sees.
struct Given {
  Image grey{1280, 480, 3};
  OverlayScene scene;

  Given() {
    for (int v = 0; v < grey.height(); ++v) std::memset(grey.row(v), 90, std::size_t{3} * 1280);
    scene.title = "a drive";
    scene.camera = "front camera";
    scene.image = grey.view();
    scene.intrinsics = {1280, 480, 1200, 1200, 639.5, 150, {-0.1, 0, 0, 0, 0}};
    scene.pose.mounting = {-1.5, 0.1, 1.3, 0.01, 0.02, -0.01};
    scene.view.emplace();
    scene.view->pose = scene.pose;
    scene.road.emplace();
    testing::RoadScene road;
    road.course.curvature = 8e-4;
    scene.road->estimate = testing::perfect_estimate(road, 80);
  }
};

/// How far the pixels at and next to (u, v) of the image are from `colour` at best.
int distance_to(const Image& picture, const Eigen::Vector2d& pixel, Colour colour) {
  int best = 255;
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      const int u = static_cast<int>(std::lround(pixel.x())) + du;
      const int v = static_cast<int>(std::lround(pixel.y() + kImageTop)) + dv;
      const std::uint8_t* p = picture.view().row(v) + std::ptrdiff_t{3} * u;
      best = std::min(best, std::max({std::abs(p[2] - colour.red), std::abs(p[1] - colour.green),
                                      std::abs(p[0] - colour.blue)}));
    }
  }
  return best;
}

TEST(Overlay, BoundariesAppearWhereTheCameraSeesThem) {
  const Given given;
  const Image picture = draw_overlay(given.scene);
  const CameraModel camera(given.scene.intrinsics);
  const GroundProjection projection(camera, given.scene.pose);
  int compared = 0;
  for (const Boundary& boundary : given.scene.road->estimate.boundaries) {
    for (const double x : {8.0, 15.0, 30.0, 60.0, 79.0}) {
      const auto pixel = projection.pixel({x, boundary.clothoid.y(x)});
      if (!pixel || !camera.in_image(*pixel) || pixel->y() > 470) continue;
      EXPECT_LT(distance_to(picture, *pixel, overlay_colour::kBoundary), 12) << boundary.id << " at " << x;
      ++compared;
    }
    const auto beyond = projection.pixel({110, boundary.clothoid.y(110)});
    EXPECT_GT(distance_to(picture, *beyond, overlay_colour::kBoundary), 50) << "it ends at 80 m";
  }
  EXPECT_GT(compared, 14);
}

TEST(Overlay, ShowsWhatWasSeenInTheImage) {
  Given given;
  given.scene.view->bars = {{300, 200, 230, true}, {320, 700, 720, false}};
  given.scene.view->windows = {{350, 400, 460, Side::left, true, 440},
                               {380, 900, 950, Side::right, false, 0}};
  given.scene.view->vehicles = {{600, 100, 700, 180, 32, 0.5, 1.8, 0.9}};
  const Image picture = draw_overlay(given.scene);
  EXPECT_LT(distance_to(picture, {215, 300}, overlay_colour::kHighResolution), 5);
  EXPECT_LT(distance_to(picture, {710, 320}, overlay_colour::kOther), 20);
  EXPECT_LT(distance_to(picture, {440, 350}, overlay_colour::kSerial), 5);
  EXPECT_LT(distance_to(picture, {920, 380}, overlay_colour::kMuted), 20);
  for (const Eigen::Vector2d& edge : {Eigen::Vector2d(600, 150), {700, 150}, {650, 100}, {650, 180}}) {
    EXPECT_LT(distance_to(picture, edge, overlay_colour::kVehicle), 12) << edge.transpose();
  }
  EXPECT_GT(distance_to(picture, {650, 140}, overlay_colour::kVehicle), 50) << "a box is not filled";
}

TEST(Overlay, TruthIsDrawnApartFromWhatIsEstimated) {
  Given given;
  given.scene.road->true_boundaries = {{{0, 6}, {150, 6}}};
  const Image picture = draw_overlay(given.scene);
  const CameraModel camera(given.scene.intrinsics);
  const GroundProjection projection(camera, given.scene.pose);
  int painted = 0;
  for (double x = 20; x < 60; x += 0.5) {
    const auto pixel = projection.pixel({x, 6});
    if (pixel && camera.in_image(*pixel) && distance_to(picture, *pixel, overlay_colour::kTruth) < 40)
      ++painted;
  }
  EXPECT_GT(painted, 20);
  EXPECT_LT(painted, 75) << "dashed";
}

TEST(Overlay, TheViewFromAboveIsToScale) {
  Given given;
  given.scene.view->vehicles = {{600, 100, 700, 180, 50, 10, 2, 0.9}};
  given.scene.road.reset();
  const Image picture = draw_overlay(given.scene);
  int left = 1280, right = 0, top = 10000, bottom = 0;
  for (int v = 480 + 90; v < picture.height() - 40; ++v) {
    const std::uint8_t* row = picture.view().row(v);
    for (int u = 0; u < 1280; ++u) {
      if (std::abs(row[3 * u + 2] - 240) > 8 || std::abs(row[3 * u] - 66) > 8) continue;
      left = std::min(left, u);
      right = std::max(right, u);
      top = std::min(top, v);
      bottom = std::max(bottom, v);
    }
  }
  // A vehicle is drawn 4.5 m long and, here, 2 m wide.
  EXPECT_NEAR((right - left) / 4.5, (bottom - top) / 2.0, 1.5);
}

TEST(Overlay, SaysSoWhereThereIsNothingToShow) {
  Given given;
  given.scene.view.reset();
  given.scene.road.reset();
  const Image not_looked_at = draw_overlay(given.scene);
  given.scene.image = {};
  const Image no_image = draw_overlay(given.scene);
  EXPECT_EQ(not_looked_at.width(), no_image.width());
  EXPECT_EQ(not_looked_at.height(), no_image.height());
  EXPECT_LT(distance_to(no_image, {100, 300}, {0, 0, 0}), 1);
  EXPECT_LT(distance_to(not_looked_at, {100, 300}, {90, 90, 90}), 1);
  given.scene.view.emplace();
  given.scene.view->fault = ImageFault::corrupt;
  EXPECT_NE(std::memcmp(draw_overlay(given.scene).view().data, no_image.view().data, 1280 * 60 * 3), 0);
}

TEST(Overlay, EveryCameraGivesAPictureThatAVideoTakes) {
  for (const auto& [width, height] : {std::pair{1281, 721}, {2560, 900}, {640, 480}, {1920, 1}}) {
    Given given;
    given.scene.intrinsics.width = width;
    given.scene.intrinsics.height = height;
    const Image picture = draw_overlay(given.scene, {.width = 960});
    EXPECT_EQ(picture.width(), 960);
    EXPECT_EQ(picture.height() % 2, 0);
  }
}

TEST(Overlay, SameSceneSamePixels) {
  const Given given;
  const Image one = draw_overlay(given.scene);
  const Image two = draw_overlay(given.scene);
  EXPECT_EQ(std::memcmp(one.view().data, two.view().data,
                        std::size_t{3} * static_cast<std::size_t>(one.width() * one.height())),
            0);
}

}  // namespace
}  // namespace lanefuse
