// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/image_header.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace lanefuse {
namespace {

using Bytes = std::span<const std::byte>;

std::int64_t big_endian(Bytes bytes, std::size_t at, int count) {
  std::int64_t number = 0;
  for (int i = 0; i < count; ++i) number = number << 8 | std::to_integer<std::int64_t>(bytes[at + i]);
  return number;
}

std::int64_t little_endian(Bytes bytes, std::size_t at, int count) {
  std::int64_t number = 0;
  for (int i = count - 1; i >= 0; --i) number = number << 8 | std::to_integer<std::int64_t>(bytes[at + i]);
  return number;
}

bool holds(Bytes bytes, std::size_t at, std::string_view text) {
  return bytes.size() >= at + text.size() &&
         std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
}

std::optional<ImageSize> positive(std::int64_t width, std::int64_t height) {
  constexpr std::int64_t kLongestSide = 0x7FFFFFFF;  // PNG's limit; the product then fits
  if (width <= 0 || height <= 0 || width > kLongestSide || height > kLongestSide) return {};
  return ImageSize{width, height};
}

std::optional<ImageSize> png_size(Bytes bytes) {
  if (bytes.size() < 24 || !holds(bytes, 12, "IHDR")) return {};
  return positive(big_endian(bytes, 16, 4), big_endian(bytes, 20, 4));
}

/// A frame header is one of SOF0..SOF15 but for DHT, JPG and DAC, which share the range.
bool is_frame_header(std::int64_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

std::optional<ImageSize> jpeg_size(Bytes bytes) {
  std::size_t at = 2;
  while (at + 9 <= bytes.size()) {
    if (big_endian(bytes, at, 1) != 0xFF) return {};
    const std::int64_t marker = big_endian(bytes, at + 1, 1);
    if (marker == 0xFF) {  // a fill byte
      ++at;
      continue;
    }
    if (is_frame_header(marker)) return positive(big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2));
    at += 2 + static_cast<std::size_t>(big_endian(bytes, at + 2, 2));
  }
  return {};
}

/// Lossy, lossless and extended files keep their sizes in different places (RFC 9649).
std::optional<ImageSize> webp_size(Bytes bytes) {
  if (bytes.size() < 30) return {};
  if (holds(bytes, 12, "VP8X")) {
    return positive(little_endian(bytes, 24, 3) + 1, little_endian(bytes, 27, 3) + 1);
  }
  if (holds(bytes, 12, "VP8 ")) {
    return positive(little_endian(bytes, 26, 2) & 0x3FFF, little_endian(bytes, 28, 2) & 0x3FFF);
  }
  if (holds(bytes, 12, "VP8L")) {
    const std::int64_t bits = little_endian(bytes, 21, 4);
    return positive((bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1);
  }
  return {};
}

}  // namespace

std::optional<ImageSize> image_size(Bytes bytes) {
  if (holds(bytes, 0, "\x89PNG\r\n\x1a\n")) return png_size(bytes);
  if (holds(bytes, 0, "\xFF\xD8")) return jpeg_size(bytes);
  if (holds(bytes, 0, "RIFF") && holds(bytes, 8, "WEBP")) return webp_size(bytes);
  return {};
}

}  // namespace lanefuse
