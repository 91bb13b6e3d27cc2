// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/lane_segmentation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {
namespace {

constexpr const char* kMend = "give an ONNX network that takes 1 x 3 x H x W and gives 1 x N x h x w";

/// OpenCV tells its own story of a network that it cannot load; ours is told once, and better.
class QuietOpenCv {
 public:
  QuietOpenCv() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
  ~QuietOpenCv() { cv::utils::logging::setLogLevel(before_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  cv::utils::logging::LogLevel before_;
};

std::string first_line(const std::string& text) {
  const std::size_t begin = std::min(text.find_first_not_of("\r\n"), text.size());
  return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

cv::dnn::Net load(const std::string& file) {
  if (file.empty()) {
    throw configuration_error("lane segmentation", "has no model", "set sources.lane_segmentation.model");
  }
  constexpr std::uintmax_t kLargest = 1U << 31U;  // [bytes]: what a protobuf message may have
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in) throw configuration_error(file, "cannot be read as the lane segmentation's model");
  if (size == 0 || size >= kLargest) throw configuration_error(file, "is no ONNX network", kMend);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  std::string why = "is no ONNX network";
  try {
    const QuietOpenCv quiet;
    cv::dnn::Net net = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
    if (!net.empty()) {
      net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
      net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
      return net;
    }
  } catch (const cv::Exception& error) {
    why = fmt::format("is no ONNX network that can be loaded ({})", first_line(error.err));
  } catch (const std::exception&) {  // of protobuf, beneath OpenCV
  }
  throw configuration_error(file, why, kMend);
}

/// The network's output as channels of one size.
struct Mask {
  const float* data;
  int channels;
  int height;
  int width;

  [[nodiscard]] float at(int channel, int row, int column) const {
    return data[(static_cast<std::ptrdiff_t>(channel) * height + row) * width + column];
  }

  /// The channel with the highest score; the first of equals.
  [[nodiscard]] int class_at(int row, int column) const {
    int best = 0;
    for (int c = 1; c < channels; ++c) {
      if (at(c, row, column) > at(best, row, column)) best = c;
    }
    return best;
  }
};

Mask mask_of(const cv::Mat& output, const std::string& model) {
  const bool has_channels = output.dims == 4 && output.size[0] == 1;
  if (output.type() != CV_32F || !(has_channels || (output.dims == 3 && output.size[0] == 1)) ||
      output.empty()) {
    std::vector<int> shape;
    for (int i = 0; i < output.dims; ++i) shape.push_back(output.size[i]);
    throw configuration_error(model, fmt::format("its output of {} is no mask", fmt::join(shape, " x ")),
                              kMend);
  }
  return {output.ptr<float>(), has_channels ? output.size[1] : 1, output.size[output.dims - 2],
          output.size[output.dims - 1]};
}

/// What of a mask counts as paint.
class Paint {
 public:
  Paint(const Mask& mask, const LaneSegmentationConfig& config)
      : mask_(mask), background_(config.background_class), least_(config.threshold) {
    if (config.logits) least_ = std::log(config.threshold / (1 - config.threshold));
  }

  [[nodiscard]] bool at(int row, int column) const {
    if (mask_.channels == 1) return mask_.at(0, row, column) >= least_;
    return mask_.class_at(row, column) != background_;
  }

 private:
  Mask mask_;
  int background_;
  double least_;
};

std::vector<ImageBar> runs_of(const Mask& mask, const Paint& paint, const ImageView& image) {
  const double across = static_cast<double>(image.width) / mask.width;
  const double down = static_cast<double>(image.height) / mask.height;
  std::vector<ImageBar> runs;
  for (int row = 0; row < mask.height; ++row) {
    int begin = -1;
    for (int column = 0; column <= mask.width; ++column) {
      const bool painted = column < mask.width && paint.at(row, column);
      if (painted && begin < 0) begin = column;
      if (painted || begin < 0) continue;
      runs.push_back({(row + 0.5) * down - 0.5, begin * across - 0.5, column * across - 0.5, false});
      begin = -1;
    }
  }
  return runs;
}

}  // namespace

struct LaneSegmentation::Network {
  cv::dnn::Net net;
};

LaneSegmentation::LaneSegmentation(const LaneSegmentationConfig& config)
    : config_(config), network_(std::make_unique<Network>(Network{load(config.model)})) {}
LaneSegmentation::~LaneSegmentation() = default;
LaneSegmentation::LaneSegmentation(LaneSegmentation&&) noexcept = default;
LaneSegmentation& LaneSegmentation::operator=(LaneSegmentation&&) noexcept = default;

std::vector<ImageBar> LaneSegmentation::find(const ImageView& image) {
  const cv::Mat pixels(image.height, image.width, image.channels == 3 ? CV_8UC3 : CV_8UC1,
                       const_cast<std::uint8_t*>(image.data),  // NOLINT: it is only read
                       static_cast<std::size_t>(image.stride));
  const cv::Size size(config_.input_width > 0 ? config_.input_width : image.width,
                      config_.input_height > 0 ? config_.input_height : image.height);
  cv::Mat output;
  try {
    const QuietOpenCv quiet;
    network_->net.setInput(cv::dnn::blobFromImage(pixels, config_.input_scale, size,
                                                  cv::Scalar::all(config_.input_mean), config_.red_first));
    output = network_->net.forward();
  } catch (const std::exception&) {
    throw configuration_error(config_.model,
                              fmt::format("cannot take an image of {} x {}", size.width, size.height), kMend);
  }
  const Mask mask = mask_of(output, config_.model);
  return runs_of(mask, Paint(mask, config_), image);
}

}  // namespace lanefuse
