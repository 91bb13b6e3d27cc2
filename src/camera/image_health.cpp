// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/image_health.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>

namespace lanefuse {
namespace {

using Bytes = std::span<const std::byte>;

bool starts_with(Bytes bytes, Bytes start) {
  return bytes.size() >= start.size() &&
         (start.empty() || std::memcmp(bytes.data(), start.data(), start.size()) == 0);
}

bool ends_with(Bytes bytes, std::string_view end) {
  return bytes.size() >= end.size() &&
         std::memcmp(bytes.data() + (bytes.size() - end.size()), end.data(), end.size()) == 0;
}

bool starts_with(Bytes bytes, std::string_view start) {
  return starts_with(bytes, std::as_bytes(std::span(start)));
}

/// Whether the file goes on to its end. Some cameras fill a message up with zeros behind it.
bool is_whole(Bytes bytes) {
  Bytes content = bytes;
  while (!content.empty() && content.back() == std::byte{0}) content = content.first(content.size() - 1);
  if (starts_with(bytes, "\xFF\xD8")) return ends_with(content, "\xFF\xD9");
  if (starts_with(bytes, "\x89PNG")) return ends_with(content, "IEND\xAE\x42\x60\x82");
  if (starts_with(bytes, "RIFF") && bytes.size() >= 8) {
    std::size_t said = 0;
    for (int i = 3; i >= 0; --i) said = said << 8 | std::to_integer<std::size_t>(bytes[4 + i]);
    return bytes.size() >= said + 8;
  }
  return true;  // of another kind: its decoder must judge
}

/// How bright the brightest channel of some of an image's pixels is.
class Brightness {
 public:
  Brightness(const ImageView& image, int first_row) {
    constexpr int kRows = 32;
    constexpr int kColumns = 100;
    const int row_step = std::max(1, (image.height - first_row) / kRows);
    const int column_step = std::max(1, image.width / kColumns);
    for (int v = first_row; v < image.height; v += row_step) {
      const std::uint8_t* const row = image.row(v);
      for (int u = 0; u < image.width; u += column_step) {
        const std::uint8_t* const pixel = row + static_cast<std::ptrdiff_t>(u) * image.channels;
        ++histogram_[*std::max_element(pixel, pixel + image.channels)];
        ++count_;
      }
    }
  }

  /// The brightness that `share` of the pixels do not exceed.
  [[nodiscard]] int quantile(double share) const {
    double below = share * count_;
    for (int value = 0; value < 256; ++value) {
      below -= histogram_[static_cast<std::size_t>(value)];
      if (below <= 0) return value;
    }
    return 255;
  }

 private:
  std::array<int, 256> histogram_{};
  int count_ = 0;
};

/// The rows at the lower end that are of one colour, all of the same.
struct BlankRows {
  int count = 0;
  int brightest = 0;  ///< channel of that colour
  int darkest = 255;
};

BlankRows blank_rows(const ImageView& image) {
  constexpr int kRowStep = 4;
  constexpr int kColumnStep = 8;
  constexpr int kSpread = 2;  ///< a decoder's rounding
  const std::uint8_t* const colour = image.row(image.height - 1);
  BlankRows blank{0, *std::max_element(colour, colour + image.channels),
                  *std::min_element(colour, colour + image.channels)};
  for (int v = image.height - 1; v >= 0; v -= kRowStep) {
    const std::uint8_t* const row = image.row(v);
    for (int u = 0; u < image.width; u += kColumnStep) {
      for (int c = 0; c < image.channels; ++c) {
        if (std::abs(row[static_cast<std::ptrdiff_t>(u) * image.channels + c] - colour[c]) > kSpread)
          return blank;
      }
    }
    blank.count = std::min(image.height, image.height - v + kRowStep - 1);
  }
  return blank;
}

/// What was not received is of one colour. A bonnet at night and a road in the glare may be, too, but hardly
/// over a large part of the image.
bool is_cut_off(const ImageView& image, const ImageHealthConfig& config) {
  const BlankRows blank = blank_rows(image);
  const bool natural = blank.brightest < config.dark || blank.darkest > config.glaring;
  return blank.count >= (natural ? config.blank_share * image.height : config.blank_rows);
}

ImageFault look_of(const ImageView& image, const ImageHealthConfig& config) {
  if (Brightness(image, 0).quantile(0.99) < config.dark) return ImageFault::too_dark;
  if (Brightness(image, image.height / 2).quantile(0.2) > config.glaring) return ImageFault::overexposed;
  if (is_cut_off(image, config)) return ImageFault::incomplete;
  return ImageFault::none;
}

}  // namespace

ImageFault ImageHealth::judge(const CameraImage& image, const std::optional<Image>& decoded,
                              const CameraIntrinsics& camera, double distance_moved) {
  const bool frozen = is_frozen(image, distance_moved);
  if (image.bytes.empty()) return ImageFault::empty;
  if (!decoded || decoded->empty()) return ImageFault::corrupt;
  if (decoded->width() != camera.width || decoded->height() != camera.height) return ImageFault::wrong_size;
  if (!is_whole(image.bytes)) return ImageFault::incomplete;
  const ImageFault look = look_of(decoded->view(), config_);
  if (look != ImageFault::none) return look;
  return frozen ? ImageFault::frozen : ImageFault::none;
}

bool ImageHealth::is_frozen(const CameraImage& image, double distance_moved) {
  // Not by !=, which goes through them one by one.
  const bool same = image.bytes.size() == last_bytes_.size() && starts_with(image.bytes, last_bytes_);
  if (!same) {
    last_bytes_ = image.bytes;
    moved_since_ = 0;
    return false;
  }
  moved_since_ += std::abs(distance_moved);
  return moved_since_ > config_.frozen_distance;
}

void ImageHealth::reset() {
  last_bytes_.clear();
  moved_since_ = 0;
}

}  // namespace lanefuse
