// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <google/protobuf/message.h>

#include "recording/mcap_records.hpp"

namespace lanefuse {

/// Private to this folder: between protobuf messages and bytes. The same message gives the same bytes.
mcap::Bytes to_bytes(const google::protobuf::Message& message);

/// Throws Error (input) naming the message's type where the bytes are none.
void parse(std::span<const std::byte> bytes, google::protobuf::Message& message);

template <class M>
M parsed(std::span<const std::byte> bytes) {
  M message;
  parse(bytes, message);
  return message;
}

/// Throws Error (input): `type`'s message is broken, `problem` says how.
[[noreturn]] void refuse(const std::string& type, const std::string& problem);

/// Refuses a message that holds more parts than any real one.
void check_count(int count, int limit, const std::string& type);
inline constexpr int kMaxFeatures = 4096;
inline constexpr int kMaxObjects = 256;

/// The number itself; refuses what is not finite.
double finite(double number, const std::string& type);

}  // namespace lanefuse
