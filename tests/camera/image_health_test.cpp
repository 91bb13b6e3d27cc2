// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/image_health.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "camera/image_codec.hpp"
#include "core/random.hpp"
#include "support/files.hpp"
#include "support/real_data.hpp"

namespace lanefuse {
namespace {

using Bytes = std::vector<std::byte>;

constexpr CameraIntrinsics kCamera{640, 360, 600, 600, 319.5, 179.5, {}};

/// A picture of which each pixel is `colour(u, v)`.
template <typename Colour>
Image picture(Colour colour, int width = kCamera.width, int height = kCamera.height) {
  Image image(width, height, 3);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      for (int c = 0; c < 3; ++c) image.row(v)[3 * u + c] = static_cast<std::uint8_t>(colour(u, v));
    }
  }
  return image;
}

Image one_colour(int value) {
  return picture([value](int, int) { return value; });
}

/// Grey asphalt with grain under a brighter sky, two bright lines.
Image day() {
  Random random(1, "grain");
  return picture([&](int u, int v) {
    const double line = std::abs(std::abs(u - 320) - (v - 180));
    const double light = v < 180 ? 180 : line < 4 ? 220 : 90;
    return light + random.uniform(-12, 12);
  });
}

/// Black but for what the headlights reach: a patch of road, with a line in it. Below it the bonnet, black.
Image night() {
  return picture([](int u, int v) {
    if (v > 330) return 0.0;
    const double lit = std::exp(-std::pow((u - 320) / 120.0, 2) - std::pow((v - 270) / 50.0, 2));
    return lit * (std::abs(u - 200 - (270 - v) / 2) < 4 ? 150 : 45);
  });
}

CameraImage message(Bytes bytes) { return {{}, "jpeg", std::move(bytes)}; }

ImageFault judge(Bytes bytes, const CameraIntrinsics& camera = kCamera) {
  const auto decoded = decode_image(bytes);
  return ImageHealth().judge(message(std::move(bytes)), decoded, camera, 1);
}

ImageFault judge(const Image& image) { return judge(encode_jpeg(image.view(), 90)); }

TEST(ImageHealth, BelievesDayAndNight) {
  EXPECT_EQ(judge(day()), ImageFault::none);
  EXPECT_EQ(judge(night()), ImageFault::none);
}

TEST(ImageHealth, NamesWhatShowsNothing) {
  EXPECT_EQ(judge(Bytes{}), ImageFault::empty);
  EXPECT_EQ(judge(one_colour(0)), ImageFault::too_dark);
  EXPECT_EQ(judge(one_colour(15)), ImageFault::too_dark);
  EXPECT_EQ(judge(one_colour(255)), ImageFault::overexposed);
  EXPECT_EQ(judge(one_colour(128)), ImageFault::incomplete);
}

TEST(ImageHealth, GlareOverHalfTheRoadIsNoFault) {
  Random random(3, "grain");
  const Image low_sun = picture([&](int u, int v) {
    const double glare = 255 * std::exp(-std::pow((u - 320) / 150.0, 2));
    return std::min(255.0, (v < 180 ? 255 : 100 + glare) + random.uniform(-10, 0));
  });
  EXPECT_EQ(judge(low_sun), ImageFault::none);
}

TEST(ImageHealth, NamesBytesThatAreNoImage) {
  Random random(2, "bytes");
  for (const std::size_t size : {1, 10, 1000, 100000}) {
    Bytes bytes(size);
    for (std::byte& b : bytes) b = static_cast<std::byte>(random.uniform(0, 256));
    EXPECT_EQ(judge(bytes), ImageFault::corrupt);
  }
}

TEST(ImageHealth, NamesAnotherSize) {
  CameraIntrinsics other = kCamera;
  other.height += 1;
  EXPECT_EQ(judge(encode_jpeg(day().view(), 90), other), ImageFault::wrong_size);
}

TEST(ImageHealth, NamesEveryCutFile) {
  const Bytes whole = encode_jpeg(day().view(), 90);
  for (int percent = 0; percent < 100; percent += 5) {
    const Bytes part(whole.begin(),
                     whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * percent / 100));
    const ImageFault fault = judge(part);
    const ImageFault expected = percent == 0                      ? ImageFault::empty
                                : fault == ImageFault::incomplete ? ImageFault::incomplete
                                                                  : ImageFault::corrupt;
    EXPECT_EQ(fault, expected) << percent << " %";
    if (percent >= 10) {
      EXPECT_EQ(fault, ImageFault::incomplete) << percent << " %";
    }
  }
  const Bytes without_end(whole.begin(), whole.end() - 2);
  EXPECT_EQ(judge(without_end), ImageFault::incomplete);
}

TEST(ImageHealth, NamesACutImageInAWholeFile) {
  const Bytes whole = encode_jpeg(day().view(), 90);
  for (int percent = 10; percent <= 90; percent += 5) {
    Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * percent / 100));
    part.insert(part.end(), {std::byte{0xFF}, std::byte{0xD9}});
    EXPECT_EQ(judge(part), ImageFault::incomplete) << percent << " %";
  }
}

TEST(ImageHealth, NamesALowerHalfOfAnyColour) {
  for (const int colour : {0, 60, 128, 255}) {
    Random random(4, "grain");
    const Image half = picture(
        [&](int, int v) { return v < 180 ? 120 + random.uniform(-9, 9) : static_cast<double>(colour); });
    const ImageFault fault = judge(half);
    EXPECT_EQ(fault, colour == 255 ? ImageFault::overexposed : ImageFault::incomplete) << colour;
  }
}

TEST(ImageHealth, TakesPaddingBehindTheFile) {
  Bytes bytes = encode_jpeg(day().view(), 90);
  bytes.resize(bytes.size() + 777);
  EXPECT_EQ(judge(bytes), ImageFault::none);
}

TEST(ImageHealth, APictureFreezesOnlyWhereTheCarMoves) {
  const Bytes bytes = encode_jpeg(day().view(), 90);
  const auto decoded = decode_image(bytes);
  ImageHealth health;
  const auto next = [&](double distance) { return health.judge(message(bytes), decoded, kCamera, distance); };
  EXPECT_EQ(next(1), ImageFault::none);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(next(0), ImageFault::none);
  EXPECT_EQ(next(0.2), ImageFault::none);
  EXPECT_EQ(next(0.2), ImageFault::frozen);
  EXPECT_EQ(next(0), ImageFault::frozen);
  const Bytes other = encode_jpeg(day().view(), 91);
  EXPECT_EQ(health.judge(message(other), decoded, kCamera, 1), ImageFault::none);
  EXPECT_EQ(next(1), ImageFault::none);
  health.reset();
  EXPECT_EQ(next(1), ImageFault::none);
}

TEST(ImageHealth, BelievesRealPicturesAndNamesTheirCuts) {
  const auto folder = testing::real_data("highway_video/still");
  LANEFUSE_NEEDS_DATA(folder);
  const CameraIntrinsics camera{1280, 720, 1160, 1155, 667, 388, {}};
  for (const char* name : {"straight_lines1.jpg", "straight_lines2.jpg", "test1.jpg", "test4.jpg"}) {
    const Bytes whole = testing::read_file(folder / name);
    EXPECT_EQ(judge(whole, camera), ImageFault::none) << name;
    for (int percent = 20; percent < 100; percent += 20) {
      Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * percent / 100));
      EXPECT_EQ(judge(part, camera), ImageFault::incomplete) << name << percent;
      part.insert(part.end(), {std::byte{0xFF}, std::byte{0xD9}});
      EXPECT_EQ(judge(part, camera), ImageFault::incomplete) << name << percent;
    }
  }
}

}  // namespace
}  // namespace lanefuse
