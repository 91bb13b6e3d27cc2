// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "sources/camera_images.hpp"

#include <gtest/gtest.h>

#include "camera/image_codec.hpp"

namespace lanefuse {
namespace {

class CameraImagesTest : public ::testing::Test {
 protected:
  CameraImagesTest() {
    rig_.sensors.push_back({2,
                            SensorKind::camera,
                            "front",
                            {0, 0, 1.25, 0, 0, 0},
                            CameraIntrinsics{320, 180, 300, 300, 160, 90, {}}});
    for (int i = 0; i < 100; ++i) {
      motion_.push_back({at(0.02 * i), {0.6 * i, 0, 0}, 30, 0});
    }
  }

  static Time at(double seconds) { return Time{} + std::chrono::hours(1) + from_seconds(seconds); }

  /// A road of one grey, darker further down, with its own number in a corner so that no two are alike.
  static CameraImage image(double seconds, int grey, int number) {
    Image pixels(320, 180, 3);
    for (int v = 0; v < 180; ++v) {
      for (int i = 0; i < 320 * 3; ++i) {
        pixels.row(v)[i] = static_cast<std::uint8_t>(std::clamp(grey + v / 4 + (v * 7 + i * 13) % 9, 0, 255));
      }
    }
    for (int i = 0; i < 48; ++i) pixels.row(10)[i] = static_cast<std::uint8_t>(number * 5 % 256);
    return {{at(seconds), at(seconds + 0.05), 2}, "jpeg", encode_jpeg(pixels.view(), 95)};
  }

  InputAccounting take(const CameraImage& image) {
    seen_.clear();
    return images_.take(image, {rig_, motion_, {}}, seen_);
  }

  Rig rig_;
  std::vector<MotionSample> motion_;
  CameraImages images_{CameraImagesConfig{}};
  std::vector<Measurement> seen_;
};

TEST_F(CameraImagesTest, AnImageIsOneItemAndLeavesAView) {
  EXPECT_EQ(take(image(0.1, 90, 1)), (InputAccounting{.used = 1}));
  ASSERT_EQ(images_.views().size(), 1u);
  EXPECT_EQ(images_.views()[0].fault, ImageFault::none);
  EXPECT_EQ(images_.views()[0].sensor_id, 2u);
  EXPECT_EQ(images_.views()[0].measured_at, at(0.1));
  images_.forget_views();
  EXPECT_TRUE(images_.views().empty());
}

TEST_F(CameraImagesTest, DamagedImagesAreRejectedAndNamed) {
  CameraImage cut = image(0.1, 90, 1);
  cut.bytes.resize(cut.bytes.size() / 2);
  EXPECT_EQ(take(cut), (InputAccounting{.rejected = 1}));
  EXPECT_EQ(images_.views().back().fault, ImageFault::incomplete);
  CameraImage none = image(0.2, 90, 2);
  none.bytes.clear();
  EXPECT_EQ(take(none), (InputAccounting{.rejected = 1}));
  EXPECT_EQ(images_.views().back().fault, ImageFault::empty);
  EXPECT_TRUE(seen_.empty());
  EXPECT_EQ(take(image(0.3, 90, 3)), (InputAccounting{.used = 1})) << "the next sound one is believed";
}

TEST_F(CameraImagesTest, ABlackImageIsNoDamage) {
  CameraImage black = image(0.1, -300, 1);
  EXPECT_EQ(take(black), (InputAccounting{.dropped = 1}));
  EXPECT_EQ(images_.views().back().fault, ImageFault::too_dark);
}

TEST_F(CameraImagesTest, AnUnknownCameraIsRejected) {
  CameraImage stranger = image(0.1, 90, 1);
  stranger.stamp.sensor_id = 9;
  EXPECT_EQ(take(stranger), (InputAccounting{.rejected = 1}));
}

TEST_F(CameraImagesTest, WithoutMotionOrOutOfOrderAnImageIsDropped) {
  EXPECT_EQ(take(image(0.2, 90, 1)), (InputAccounting{.used = 1}));
  EXPECT_EQ(take(image(0.1, 90, 2)), (InputAccounting{.dropped = 1}));
  motion_.clear();
  EXPECT_EQ(take(image(0.3, 90, 3)), (InputAccounting{.dropped = 1}));
}

}  // namespace
}  // namespace lanefuse
