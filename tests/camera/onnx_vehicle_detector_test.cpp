// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "camera/onnx_vehicle_detector.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/onnx_model.hpp"

namespace lanefuse {
namespace {

using testing::onnx_node;
using testing::onnx_tensor;
using testing::onnx_value;
using testing::ProtobufMessage;

/// The network's images: 4 x 2 pixels, each of which becomes one row (cx, cy, w, h, score 0, score 1).
constexpr int kColumns = 4;
constexpr int kRows = 2;
constexpr int kNumbers = 6;
const CameraIntrinsics kCamera{400, 200, 300, 300, 199.5, 99.5, {}};

/// Green gives cx (0 to 4), red the score of class 1; boxes are 1 x 0.6 around row 1.4.
std::vector<std::byte> box_network() {
  const std::vector<float> weights{0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
  const std::vector<float> biases{0, 1.4F, 1, 0.6F, 0, 0};
  const ProtobufMessage kernel =
      ProtobufMessage().text(1, "kernel_shape").number(8, 1).number(8, 1).number(20, 7);
  const ProtobufMessage shape = ProtobufMessage()
                                    .number(1, 3)
                                    .number(2, 7)
                                    .number(7, 1)
                                    .number(7, kNumbers)
                                    .number(7, kColumns * kRows)
                                    .text(8, "shape");
  ProtobufMessage graph;
  graph.message(1, onnx_node("Conv", {"image", "weights", "biases"}, "numbers").message(5, kernel));
  graph.message(1, onnx_node("Reshape", {"numbers", "shape"}, "boxes"));
  graph.text(2, "boxes of pixels");
  graph.message(5, onnx_tensor("weights", {kNumbers, 3, 1, 1}, weights));
  graph.message(5, onnx_tensor("biases", {kNumbers}, biases));
  graph.message(5, shape);
  graph.message(11, onnx_value("image", {1, 3, kRows, kColumns}));
  graph.message(12, onnx_value("boxes", {1, kNumbers, kColumns * kRows}));
  const ProtobufMessage opset = ProtobufMessage().text(1, "").number(2, 11);
  return ProtobufMessage().number(1, 6).message(7, graph).message(8, opset).bytes();
}

std::filesystem::path written(const std::string& name, const std::vector<std::byte>& bytes) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return file;
}

OnnxVehicleDetectorConfig config_for(const std::filesystem::path& model) {
  OnnxVehicleDetectorConfig config;
  config.model = model;
  config.input_width = kColumns;
  config.input_height = kRows;
  config.transposed = true;
  config.vehicle_classes = {1};
  return config;
}

/// Paints the block of the camera's image that becomes one of the network's pixels.
void paint(Image& image, int column, int green, int red) {
  for (int v = 0; v < 100; ++v) {
    for (int u = 100 * column; u < 100 * (column + 1); ++u) {
      image.row(v)[3 * u + 1] = static_cast<std::uint8_t>(green);
      image.row(v)[3 * u + 2] = static_cast<std::uint8_t>(red);
    }
  }
}

CameraPose some_pose() {
  CameraPose pose;
  pose.mounting.z = 1.3;
  return pose;
}

TEST(OnnxVehicleDetector, PlacesTheNetworksBoxesOnTheRoad) {
  OnnxVehicleDetector detector(kCamera, config_for(written("boxes.onnx", box_network())));
  Image image(kCamera.width, kCamera.height, 3);
  paint(image, 0, 128, 230);  // in the middle, sure
  paint(image, 1, 130, 200);  // nearly the same: covered by the first
  paint(image, 2, 40, 150);   // to the left, less sure
  paint(image, 3, 200, 50);   // too unsure
  const std::vector<VehicleBox> boxes = detector.detect(image.view(), some_pose());
  ASSERT_EQ(boxes.size(), 2U);
  for (const VehicleBox& box : boxes) {
    EXPECT_NEAR(box.right - box.left, 100, 1.5);
    EXPECT_NEAR(box.bottom, 170, 1);
    EXPECT_NEAR(box.distance, 1.3 * 300 / (170 - 99.5), 0.1);
    EXPECT_NEAR(box.width, box.distance * 100 / 300, 0.1);
  }
  const VehicleBox& sure = boxes[0].confidence > boxes[1].confidence ? boxes[0] : boxes[1];
  const VehicleBox& left = boxes[0].confidence > boxes[1].confidence ? boxes[1] : boxes[0];
  EXPECT_NEAR(sure.confidence, 230.0 / 255, 0.01);
  EXPECT_NEAR((sure.left + sure.right) / 2, 400 * 128.0 / 255, 1);
  EXPECT_GT(left.lateral, 1);
}

TEST(OnnxVehicleDetector, NamesAModelThatIsNone) {
  EXPECT_THROW(OnnxVehicleDetector(kCamera, config_for("/nowhere/model.onnx")), Error);
  const auto file = written("none.onnx", std::vector<std::byte>(64, std::byte{0x5a}));
  try {
    const OnnxVehicleDetector detector(kCamera, config_for(file));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("none.onnx"), std::string::npos);
  }
}

TEST(OnnxVehicleDetector, NamesAnOutputOfAnotherShape) {
  OnnxVehicleDetectorConfig config = config_for(written("shape.onnx", box_network()));
  config.vehicle_classes = {2, 5, 7};
  OnnxVehicleDetector detector(kCamera, config);
  const Image image(kCamera.width, kCamera.height, 3);
  EXPECT_THROW(static_cast<void>(detector.detect(image.view(), some_pose())), Error);
}

}  // namespace
}  // namespace lanefuse
