// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "foxglove/log.pb.h"
#include "recording/foxglove_fields.hpp"
#include "recording/message_bytes.hpp"
#include "recording/viewer_codec.hpp"

namespace lanefuse {
namespace {

foxglove::Log::Level level_of(EstimateStatus status) {
  switch (status) {
    case EstimateStatus::ok:
      return foxglove::Log::INFO;
    case EstimateStatus::degraded:
      return foxglove::Log::WARNING;
    case EstimateStatus::invalid:
      return foxglove::Log::ERROR;
  }
  return foxglove::Log::UNKNOWN;
}

}  // namespace

mcap::Bytes encode_status(const LaneEstimate& estimate) {
  foxglove::Log message;
  put(estimate.time, *message.mutable_timestamp());
  message.set_level(level_of(estimate.status));
  message.set_name("lanefuse");
  message.set_message(std::string(to_string(estimate.status)) + ": " + to_string(estimate.reason));
  return to_bytes(message);
}

}  // namespace lanefuse
