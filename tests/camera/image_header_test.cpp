// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/image_header.hpp"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "camera/image_codec.hpp"
#include "core/random.hpp"

namespace lanefuse {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes_of(const std::string& text) {
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

/// The head of a PNG file of 640 x 360.
Bytes png() {
  using namespace std::string_literals;
  return bytes_of("\x89PNG\r\n\x1a\n\0\0\0\x0DIHDR\0\0\x02\x80\0\0\x01\x68\x08\x02\0\0\0"s);
}

/// The head of a lossless WebP file of 640 x 360: 14 bits each of width - 1 and height - 1.
Bytes webp() {
  using namespace std::string_literals;
  constexpr unsigned kSizes = 639 | 359 << 14;
  std::string head = "RIFF\x20\0\0\0WEBPVP8L\x10\0\0\0\x2F"s;
  for (int i = 0; i < 4; ++i) head += static_cast<char>(kSizes >> 8 * i & 0xFF);
  return bytes_of(head + "\0\0\0\0\0\0\0\0"s);
}

Bytes jpeg() { return encode_jpeg(Image(640, 360, 3).view(), 80); }

TEST(ImageHeader, ReadsTheSizeOfEachFormat) {
  for (const Bytes& bytes : {jpeg(), png(), webp()}) {
    const auto size = image_size(bytes);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 640);
    EXPECT_EQ(size->height, 360);
    EXPECT_EQ(size->pixels(), 640 * 360);
  }
}

TEST(ImageHeader, ACutFileHasItsSizeOrNone) {
  for (const Bytes& whole : {jpeg(), png(), webp()}) {
    for (std::size_t length = 0; length < whole.size(); ++length) {
      // A copy of its own, so that a sanitizer sees a read past the end.
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
      const auto size = image_size(part);
      if (size) {
        EXPECT_EQ(size->pixels(), 640 * 360) << length;
      }
    }
  }
}

TEST(ImageHeader, SurvivesAnyChange) {
  Random random(5, "flips");
  for (const Bytes& whole : {jpeg(), png(), webp()}) {
    for (int i = 0; i < 2000; ++i) {
      Bytes changed = whole;
      for (int flips = 0; flips < 3; ++flips) {
        const auto at = static_cast<std::size_t>(random.uniform(0, static_cast<double>(changed.size())));
        changed[at] = static_cast<std::byte>(random.uniform(0, 256));
      }
      const auto size = image_size(changed);
      if (size) {
        EXPECT_GT(size->pixels(), 0);
      }
    }
  }
}

TEST(ImageHeader, ARandomChangeNeverBreaksTheDecoder) {
  Random random(6, "flips");
  const Bytes whole = encode_jpeg(Image(64, 32, 3).view(), 80);
  for (int i = 0; i < 500; ++i) {
    Bytes changed = whole;
    changed[static_cast<std::size_t>(random.uniform(0, static_cast<double>(changed.size())))] =
        static_cast<std::byte>(random.uniform(0, 256));
    const auto image = decode_image(changed);
    if (image) {
      EXPECT_LE(static_cast<std::int64_t>(image->width()) * image->height(), kMaxPixels);
    }
  }
}

TEST(ImageHeader, WhatClaimsToBeHugeIsNotDecoded) {
  Bytes bytes = png();
  bytes[16] = std::byte{0x7F};
  ASSERT_TRUE(image_size(bytes));
  EXPECT_GT(image_size(bytes)->pixels(), kMaxPixels);
  EXPECT_FALSE(decode_image(bytes));
}

}  // namespace
}  // namespace lanefuse
