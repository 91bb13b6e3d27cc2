// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/picture_file.hpp"

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "core/error.hpp"

namespace lanefuse {

void write_picture(const std::filesystem::path& path, const ImageView& image) {
  const std::string ending = path.extension().string();
  if (ending != ".png" && ending != ".jpg") {
    throw configuration_error(path.string(), "is no name of a picture", "let it end with .png or .jpg");
  }
  const cv::Mat mat(image.height, image.width, image.channels == 3 ? CV_8UC3 : CV_8UC1,
                    const_cast<std::uint8_t*>(image.data),  // NOLINT: it is only read
                    static_cast<std::size_t>(image.stride));
  std::vector<std::uint8_t> encoded;
  cv::imencode(ending, mat, encoded);
  const std::filesystem::path part = path.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out.write(reinterpret_cast<const char*>(encoded.data()), static_cast<std::streamsize>(encoded.size()));
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, path, failed);
  if (!out || failed) {
    std::filesystem::remove(part, failed);
    throw input_error(path.string(), "could not be written", "is there room on the disk?");
  }
}

}  // namespace lanefuse
