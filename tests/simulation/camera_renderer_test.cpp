// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "simulation/camera_renderer.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "simulation/rendered_scene.hpp"

namespace lanefuse {
namespace {

using testing::clean_picture;
using testing::green;
using testing::Moments;
using testing::RenderedScene;
using testing::same_pixels;

/// Light of a pixel: without the display's tone curve, so that it is the paint's share.
double light(const Image& image, int u, int v) { return std::pow(green(image, u, v) / 255.0, 2.2); }

/// What a row shows of a line, over the straight line through what lies beside it.
struct Bar {
  double centre = 0;  ///< [px]
  double sum = 0;     ///< over the row
};
/// `smear` [px]: how far the line moves sideways from one row to the next.
Bar bar(const Image& image, const TrueMarking& truth, double smear) {
  const double margin = 4 + 2 * smear;
  const int first = static_cast<int>(std::floor(truth.left - margin));
  const int last = static_cast<int>(std::ceil(truth.right + margin));
  if (first < 0 || last >= image.width()) return {};
  const int v = static_cast<int>(std::lround(truth.row));
  const auto ground_at = [&](int u) {
    return (light(image, u - 1, v) + light(image, u, v) + light(image, u + 1, v)) / 3;
  };
  const double from = ground_at(first + 1);
  const double to = ground_at(last - 1);
  Bar bar;
  double moment = 0;
  for (int u = first + 2; u < last - 1; ++u) {
    const double ground = from + (to - from) * (u - first - 1) / (last - first - 2);
    const double over = light(image, u, v) - ground;
    bar.sum += over;
    moment += over * u;
  }
  bar.centre = moment / bar.sum;
  return bar;
}

double smear_of(const ImageTruth& truth, int line, double row) {
  const auto above = truth.marking(line, row - 0.5);
  const auto below = truth.marking(line, row + 0.5);
  return above && below ? std::abs(above->column - below->column) : 0;
}

/// Whether the paint fills the row from its upper to its lower edge, and those beside it.
bool filled(const ImageTruth& truth, int line, int v) {
  for (const double row : {v - 1.5, v - 0.5, v + 0.5, v + 1.5}) {
    const auto there = truth.marking(line, row);
    if (!there || !there->visible()) return false;
  }
  return true;
}

/// Shows every bar of the image that a line fills between 10 and 110 m.
template <typename Seen>
void watch_bars(const Image& image, const ImageTruth& truth, Seen seen) {
  for (const int line : truth.lines()) {
    for (int v = image.height() - 2; v > 1; --v) {
      const auto there = truth.marking(line, v);
      if (!there || there->ground.x() < 10 || there->ground.x() > 110 || !filled(truth, line, v)) continue;
      const Bar found = bar(image, *there, smear_of(truth, line, v));
      if (found.sum > 0) seen(*there, found);
    }
  }
}

struct Place {
  const char* name;
  CameraIntrinsics camera;
  RoadKind road;
};

class RenderedPaint : public ::testing::TestWithParam<Place> {};

TEST_P(RenderedPaint, LiesWhereTheTruthSays) {
  Moments errors;
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    RenderedScene at(seed, GetParam().road);
    at.scene().vehicles.clear();
    const CameraRenderer renderer(GetParam().camera, clean_picture());
    const Image image = renderer.render(at.scene(), at.mounting());
    const ImageTruth truth(at.scene(), renderer.camera(), at.mounting());
    watch_bars(image, truth, [&](const TrueMarking& there, const Bar& found) {
      errors.add(found.centre - there.column);
      worst = std::max(worst, std::abs(found.centre - there.column));
    });
  }
  EXPECT_GT(errors.count(), 300);
  EXPECT_LT(worst, 0.2);
  EXPECT_LT(errors.rms(), 0.06);
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("rms", std::to_string(errors.rms()));
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, RenderedPaint,
    ::testing::Values(Place{"serial", serial_camera_intrinsics(), RoadKind::gentle},
                      Place{"high_resolution", high_resolution_camera_intrinsics(), RoadKind::gentle},
                      Place{"sharp_bend", high_resolution_camera_intrinsics(), RoadKind::sharp}),
    [](const auto& instance) { return instance.param.name; });

TEST(CameraRenderer, PaintFillsItsShareOfAPixel) {
  // The light over the ground, summed along the row, is the paint's width in pixels, far away as well, where
  // it is one pixel wide.
  RenderedScene at(1);
  at.scene().vehicles.clear();
  const CameraRenderer renderer(high_resolution_camera_intrinsics(), clean_picture());
  const Image image = renderer.render(at.scene(), at.mounting());
  const ImageTruth truth(at.scene(), renderer.camera(), at.mounting());
  std::array<Moments, 3> a_pixel;  // of width, by distance
  watch_bars(image, truth, [&](const TrueMarking& there, const Bar& found) {
    const auto bin = static_cast<std::size_t>(there.ground.x() / 40);
    a_pixel.at(bin).add(found.sum / (there.right - there.left));
  });
  for (const Moments& share : a_pixel) {
    ASSERT_GT(share.count(), 20);
    EXPECT_NEAR(share.mean() / a_pixel[0].mean(), 1, 0.1);
    EXPECT_LT(share.sigma(), 0.1 * share.mean());
  }
}

TEST(CameraRenderer, DashesEndWhereTheTruthSays) {
  RenderedScene at(2);
  at.scene().vehicles.clear();
  const CameraRenderer renderer(serial_camera_intrinsics(), clean_picture());
  const Image image = renderer.render(at.scene(), at.mounting());
  const ImageTruth truth(at.scene(), renderer.camera(), at.mounting());
  double right = 0, wrong = 0;
  for (const int line : truth.lines()) {
    for (int v = 0; v < image.height(); ++v) {
      const auto there = truth.marking(line, v);
      if (!there || there->hidden || there->ground.x() > 90) continue;
      const Bar found = bar(image, *there, smear_of(truth, line, v));
      if (found.sum == 0) continue;
      const bool bright = found.sum > 0.25 * (there->right - there->left);
      (bright == there->painted ? right : wrong) += 1;
    }
  }
  EXPECT_GT(right, 200);
  EXPECT_LT(wrong / right, 0.03);  // at the very ends
}

TEST(CameraRenderer, GivesTheSameBytesWhateverTheThreads) {
  const RenderedScene at(3);
  RenderConfig config;
  config.threads = 1;
  const Image alone = CameraRenderer(serial_camera_intrinsics(), config).render(at.scene(), at.mounting());
  config.threads = 3;
  const CameraRenderer renderer(serial_camera_intrinsics(), config);
  EXPECT_TRUE(same_pixels(alone, renderer.render(at.scene(), at.mounting())));
  EXPECT_TRUE(same_pixels(alone, renderer.render(at.scene(), at.mounting())));
}

TEST(CameraRenderer, OtherSeedsAndMomentsHaveOtherNoise) {
  RenderedScene at(3);
  RenderConfig config;
  const Image one = CameraRenderer(serial_camera_intrinsics(), config).render(at.scene(), at.mounting());
  at.scene().time += std::chrono::milliseconds(40);
  const Image later = CameraRenderer(serial_camera_intrinsics(), config).render(at.scene(), at.mounting());
  EXPECT_FALSE(same_pixels(one, later));
  at.scene().time -= std::chrono::milliseconds(40);
  config.seed = 2;
  const Image other = CameraRenderer(serial_camera_intrinsics(), config).render(at.scene(), at.mounting());
  EXPECT_FALSE(same_pixels(one, other));
}

/// Mean of the middle of the picture, from row to row.
double brightness(const Image& image, double from, double to) {
  Moments moments;
  for (int v = static_cast<int>(from * image.height()); v < static_cast<int>(to * image.height()); ++v) {
    for (int u = image.width() / 3; u < image.width() * 2 / 3; ++u) moments.add(green(image, u, v));
  }
  return moments.mean();
}

TEST(CameraRenderer, ConditionsDiffer) {
  RenderedScene at(1);
  at.scene().vehicles.clear();
  std::array<double, kAllImageConditions.size()> sky{}, road{}, contrast{};
  for (std::size_t i = 0; i < sky.size(); ++i) {
    RenderConfig config = clean_picture();
    config.conditions = kAllImageConditions.at(i);
    const CameraRenderer renderer(serial_camera_intrinsics(), config);
    const Image image = renderer.render(at.scene(), at.mounting());
    sky.at(i) = brightness(image, 0, 0.2);
    road.at(i) = brightness(image, 0.8, 1);
    Moments bars;
    watch_bars(image, ImageTruth(at.scene(), renderer.camera(), at.mounting()),
               [&](const TrueMarking& there, const Bar& found) {
                 if (there.ground.x() < 40) bars.add(found.sum / (there.right - there.left));
               });
    contrast.at(i) = bars.mean();
  }
  const auto [clear, low_sun, wet, night] = contrast;
  EXPECT_GT(clear, 2 * low_sun);
  EXPECT_GT(clear, 2 * wet);
  EXPECT_GT(sky[1], sky[0]);
  EXPECT_GT(sky[2], 2 * sky[3]);
  EXPECT_GT(road[0], road[2]);
  EXPECT_GT(road[3], 25);  // in the headlights
}

TEST(CameraRenderer, FogHidesWhatIsFar) {
  RenderedScene at(1);
  at.scene().vehicles.clear();
  at.scene().visibility = 30;
  const CameraRenderer renderer(high_resolution_camera_intrinsics(), clean_picture());
  const Image image = renderer.render(at.scene(), at.mounting());
  const ImageTruth truth(at.scene(), renderer.camera(), at.mounting());
  Moments near, far;
  watch_bars(image, truth, [&](const TrueMarking& there, const Bar& found) {
    if (there.ground.x() < 15) near.add(found.sum / (there.right - there.left));
    if (there.ground.x() > 60) far.add(found.sum / (there.right - there.left));
  });
  ASSERT_GT(near.count(), 10);
  EXPECT_GT(near.mean(), 0.05);
  EXPECT_TRUE(far.count() == 0 || far.mean() < 0.01);
}

TEST(ImageConditions, AreCalledByTheirNames) {
  for (const ImageConditions conditions : kAllImageConditions) {
    EXPECT_EQ(image_conditions(to_string(conditions)), conditions);
  }
  EXPECT_FALSE(image_conditions("snow"));
}

}  // namespace
}  // namespace lanefuse
