// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace lanefuse::testing {

/// A protobuf message, written field by field.
class ProtobufMessage {
 public:
  ProtobufMessage& number(int field, std::uint64_t value) {
    varint(static_cast<std::uint64_t>(field) << 3U);
    varint(value);
    return *this;
  }
  ProtobufMessage& text(int field, const std::string& value) {
    varint(static_cast<std::uint64_t>(field) << 3U | 2U);
    varint(value.size());
    bytes_ += value;
    return *this;
  }
  ProtobufMessage& message(int field, const ProtobufMessage& value) { return text(field, value.bytes_); }
  ProtobufMessage& floats(int field, const std::vector<float>& values) {
    std::string packed(values.size() * sizeof(float), '\0');
    std::memcpy(packed.data(), values.data(), packed.size());
    return text(field, packed);
  }
  [[nodiscard]] std::vector<std::byte> bytes() const {
    const auto view = std::as_bytes(std::span(bytes_));
    return {view.begin(), view.end()};
  }

 private:
  std::string bytes_;

  void varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7U) bytes_ += static_cast<char>(value | 0x80U);
    bytes_ += static_cast<char>(value);
  }
};

/// A named value of the graph: floats of that shape.
inline ProtobufMessage onnx_value(const std::string& name, const std::vector<int>& shape) {
  ProtobufMessage dimensions;
  for (const int size : shape) {
    dimensions.message(1, ProtobufMessage().number(1, static_cast<std::uint64_t>(size)));
  }
  const ProtobufMessage tensor = ProtobufMessage().number(1, 1).message(2, dimensions);
  return ProtobufMessage().text(1, name).message(2, ProtobufMessage().message(1, tensor));
}

inline ProtobufMessage onnx_tensor(const std::string& name, const std::vector<int>& shape,
                                   const std::vector<float>& values) {
  ProtobufMessage tensor;
  for (const int size : shape) tensor.number(1, static_cast<std::uint64_t>(size));
  return tensor.number(2, 1).text(8, name).floats(9, values);
}

inline ProtobufMessage onnx_node(const std::string& type, const std::vector<std::string>& inputs,
                                 const std::string& output) {
  ProtobufMessage node;
  for (const std::string& input : inputs) node.text(1, input);
  return node.text(2, output).text(3, type).text(4, type);
}

/// An ONNX network on images of 3 x `height` x `width`: one 1x1 convolution to as many channels as there are
/// `rows` of (red, green, blue, bias), and a sigmoid behind it where asked for.
inline std::vector<std::byte> pixel_network(int width, int height,
                                            const std::vector<std::array<float, 4>>& rows, bool sigmoid) {
  std::vector<float> weights;
  std::vector<float> biases;
  for (const auto& row : rows) {
    weights.insert(weights.end(), row.begin(), row.begin() + 3);
    biases.push_back(row[3]);
  }
  const int channels = static_cast<int>(rows.size());
  const std::string last = sigmoid ? "logits" : "mask";
  const ProtobufMessage kernel =
      ProtobufMessage().text(1, "kernel_shape").number(8, 1).number(8, 1).number(20, 7);
  ProtobufMessage graph;
  graph.message(1, onnx_node("Conv", {"image", "weights", "biases"}, last).message(5, kernel));
  if (sigmoid) graph.message(1, onnx_node("Sigmoid", {last}, "mask"));
  graph.text(2, "pixels");
  graph.message(5, onnx_tensor("weights", {channels, 3, 1, 1}, weights));
  graph.message(5, onnx_tensor("biases", {channels}, biases));
  graph.message(11, onnx_value("image", {1, 3, height, width}));
  graph.message(12, onnx_value("mask", {1, channels, height, width}));
  const ProtobufMessage opset = ProtobufMessage().text(1, "").number(2, 11);
  return ProtobufMessage().number(1, 6).message(7, graph).message(8, opset).bytes();
}

}  // namespace lanefuse::testing
