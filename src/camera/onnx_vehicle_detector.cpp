// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/onnx_vehicle_detector.hpp"

#include <algorithm>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include <fmt/format.h>

#include "camera/ground_projection.hpp"
#include "core/error.hpp"

namespace lanefuse {
namespace {

/// A box of the network in pixels of the camera's image.
struct ScoredBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
  double score = 0;
};

double overlap(const ScoredBox& a, const ScoredBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  if (!(width > 0) || !(height > 0)) return 0;
  const auto area = [](const ScoredBox& box) { return (box.right - box.left) * (box.bottom - box.top); };
  return width * height / (area(a) + area(b) - width * height);
}

/// The best boxes, none overlapping a better one more than `most`.
std::vector<ScoredBox> without_overlap(std::vector<ScoredBox> boxes, double most) {
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const ScoredBox& a, const ScoredBox& b) { return a.score > b.score; });
  std::vector<ScoredBox> kept;
  for (const ScoredBox& box : boxes) {
    const bool covered = std::any_of(kept.begin(), kept.end(),
                                     [&](const ScoredBox& better) { return overlap(better, box) > most; });
    if (!covered) kept.push_back(box);
  }
  return kept;
}

cv::dnn::Net read_network(const std::filesystem::path& model) {
  if (!std::filesystem::is_regular_file(model)) throw configuration_error(model.string(), "cannot be read");
  try {
    return cv::dnn::readNetFromONNX(model.string());
  } catch (const cv::Exception& error) {
    throw configuration_error(model.string(), fmt::format("is no network that can be read ({})", error.err));
  }
}

}  // namespace

class OnnxVehicleDetector::State {
 public:
  State(const CameraIntrinsics& intrinsics, OnnxVehicleDetectorConfig config)
      : camera_(intrinsics), config_(std::move(config)), network_(read_network(config_.model)) {}

  std::vector<VehicleBox> detect(const ImageView& image, const CameraPose& pose) {
    const GroundProjection projection(camera_, pose);
    std::vector<VehicleBox> vehicles;
    for (const ScoredBox& box : without_overlap(boxes_of(rows(image)), config_.most_overlap)) {
      const auto left = projection.ground({box.left, box.bottom});
      const auto right = projection.ground({box.right, box.bottom});
      if (!left || !right) continue;  // stands on no road
      const Eigen::Vector2d middle = (*left + *right) / 2;
      vehicles.push_back({box.left, box.top, box.right, box.bottom, middle.x(), middle.y(),
                          left->y() - right->y(), box.score});
    }
    std::stable_sort(vehicles.begin(), vehicles.end(),
                     [](const VehicleBox& a, const VehicleBox& b) { return a.distance < b.distance; });
    return vehicles;
  }

 private:
  CameraModel camera_;
  OnnxVehicleDetectorConfig config_;
  cv::dnn::Net network_;

  [[nodiscard]] cv::Mat rows(const ImageView& image);
  [[nodiscard]] std::vector<ScoredBox> boxes_of(const cv::Mat& rows) const;
};

/// The network's output, one candidate a row.
cv::Mat OnnxVehicleDetector::State::rows(const ImageView& image) {
  if (image.channels != 3) throw configuration_error(config_.model.string(), "needs images in colour");
  // OpenCV has no view of constant pixels; nothing is written through this one.
  const cv::Mat pixels(image.height, image.width, CV_8UC3, const_cast<std::uint8_t*>(image.data),
                       static_cast<std::size_t>(image.stride));
  cv::Mat output;
  try {
    network_.setInput(cv::dnn::blobFromImage(
        pixels, config_.input_scale, {config_.input_width, config_.input_height}, {}, config_.red_first));
    output = network_.forward();
  } catch (const cv::Exception& error) {
    throw configuration_error(config_.model.string(),
                              fmt::format("does not take such images ({})", error.err),
                              "check the input's size");
  }
  const bool right_shape = (output.dims == 3 && output.size[0] == 1) || output.dims == 2;
  if (!right_shape || output.type() != CV_32F) {
    throw configuration_error(config_.model.string(), "its output is no table of boxes");
  }
  cv::Mat table(output.size[output.dims - 2], output.size[output.dims - 1], CV_32F, output.data);
  table = config_.transposed ? cv::Mat(table.t()) : table.clone();
  const int first_score = config_.has_objectness ? 5 : 4;
  const auto last = std::max_element(config_.vehicle_classes.begin(), config_.vehicle_classes.end());
  if (last == config_.vehicle_classes.end() || table.cols <= first_score + *last) {
    throw configuration_error(
        config_.model.string(),
        fmt::format("its output has {} columns, too few for the vehicle classes", table.cols),
        "check the classes and whether the output is transposed");
  }
  return table;
}

std::vector<ScoredBox> OnnxVehicleDetector::State::boxes_of(const cv::Mat& rows) const {
  const CameraIntrinsics& camera = camera_.intrinsics();
  const double across = static_cast<double>(camera.width) / config_.input_width;
  const double down = static_cast<double>(camera.height) / config_.input_height;
  std::vector<ScoredBox> boxes;
  for (int i = 0; i < rows.rows; ++i) {
    const auto* row = rows.ptr<float>(i);
    double score = 0;
    for (const int c : config_.vehicle_classes) {
      score = std::max(score, static_cast<double>(row[(config_.has_objectness ? 5 : 4) + c]));
    }
    if (config_.has_objectness) score *= static_cast<double>(row[4]);
    if (!(score >= config_.least_score)) continue;
    const double x = static_cast<double>(row[0]);
    const double y = static_cast<double>(row[1]);
    const double half_width = static_cast<double>(row[2]) / 2;
    const double half_height = static_cast<double>(row[3]) / 2;
    if (!(half_width > 0) || !(half_height > 0)) continue;
    boxes.push_back({std::max(0.0, (x - half_width) * across), std::max(0.0, (y - half_height) * down),
                     std::min(camera.width - 1.0, (x + half_width) * across),
                     std::min(camera.height - 1.0, (y + half_height) * down), std::min(score, 1.0)});
  }
  return boxes;
}

OnnxVehicleDetector::OnnxVehicleDetector(const CameraIntrinsics& intrinsics, OnnxVehicleDetectorConfig config)
    : state_(std::make_unique<State>(intrinsics, std::move(config))) {}
OnnxVehicleDetector::~OnnxVehicleDetector() = default;
OnnxVehicleDetector::OnnxVehicleDetector(OnnxVehicleDetector&&) noexcept = default;
OnnxVehicleDetector& OnnxVehicleDetector::operator=(OnnxVehicleDetector&&) noexcept = default;

std::vector<VehicleBox> OnnxVehicleDetector::detect(const ImageView& image, const CameraPose& pose) {
  return state_->detect(image, pose);
}

}  // namespace lanefuse
