// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "recording/mcap_records.hpp"

namespace lanefuse {

/// How a topic's messages are described in the file.
struct MessageSchema {
  std::string name;  ///< "lanefuse.v1.LaneEstimate"
  mcap::Bytes
      descriptor_set;   ///< a serialized google.protobuf.FileDescriptorSet with all that the message imports
  bool is_osi = false;  ///< by ASAM OSI: its channels name OSI's version
};

/// `topic` must be one of recording/topics.hpp.
MessageSchema schema_of(std::string_view topic);

/// The name alone; empty for topics that this version does not know.
std::string schema_name_of(std::string_view topic);

/// The version of protobuf that encodes the messages: "3.21.12".
std::string protobuf_version();

}  // namespace lanefuse
