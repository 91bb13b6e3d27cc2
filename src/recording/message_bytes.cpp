// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/message_bytes.hpp"

#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace lanefuse {

mcap::Bytes to_bytes(const google::protobuf::Message& message) {
  mcap::Bytes bytes(message.ByteSizeLong());
  [[maybe_unused]] const bool written =
      message.SerializeToArray(bytes.data(), static_cast<int>(bytes.size()));
  assert(written);
  return bytes;
}

void parse(std::span<const std::byte> bytes, google::protobuf::Message& message) {
  constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
  if (bytes.size() > kMaxBytes) refuse(message.GetTypeName(), "larger than 64 MiB");
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    refuse(message.GetTypeName(), "its bytes are no such message");
  }
}

void refuse(const std::string& type, const std::string& problem) { throw input_error(type, problem); }

void check_count(int count, int limit, const std::string& type) {
  if (count > limit) refuse(type, fmt::format("{} parts, at most {} are possible", count, limit));
}

double finite(double number, const std::string& type) {
  if (!std::isfinite(number)) refuse(type, "a number is not finite");
  return number;
}

}  // namespace lanefuse
