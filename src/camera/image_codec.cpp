// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/image_codec.hpp"

#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "camera/image_header.hpp"

namespace lanefuse {

std::optional<Image> decode_image(std::span<const std::byte> bytes) {
  const std::optional<ImageSize> size = image_size(bytes);
  if (!size || size->pixels() > kMaxPixels) return {};
  // OpenCV's decoders report damage by an empty image, and some of it by throwing.
  cv::Mat decoded;
  try {
    const cv::Mat input(1, static_cast<int>(bytes.size()), CV_8UC1,
                        const_cast<std::byte*>(bytes.data()));  // NOLINT: it is only read
    decoded = cv::imdecode(input, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return {};
  }
  if (decoded.empty()) return {};
  Image image(decoded.cols, decoded.rows, 3);
  for (int v = 0; v < decoded.rows; ++v) {
    std::memcpy(image.row(v), decoded.ptr(v), static_cast<std::size_t>(decoded.cols) * 3);
  }
  return image;
}

std::vector<std::byte> encode_jpeg(const ImageView& image, int quality) {
  const cv::Mat mat(image.height, image.width, image.channels == 3 ? CV_8UC3 : CV_8UC1,
                    const_cast<std::uint8_t*>(image.data),  // NOLINT: it is only read
                    static_cast<std::size_t>(image.stride));
  std::vector<std::uint8_t> encoded;
  cv::imencode(".jpg", mat, encoded, {cv::IMWRITE_JPEG_QUALITY, quality});
  std::vector<std::byte> bytes(encoded.size());
  std::memcpy(bytes.data(), encoded.data(), encoded.size());
  return bytes;
}

}  // namespace lanefuse
