// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/topic_writer.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/message_schema.hpp"
#include "recording/osi_version.hpp"
#include "recording/topics.hpp"

namespace lanefuse {

TopicWriter::TopicWriter(const std::filesystem::path& path, const RecordingHead& head)
    : file_(path.string()), writer_(path) {
  writer_.write(to_metadata(head));
  writer_.write(osi_trace_metadata());
}

void TopicWriter::write(const Place& place, Time measured_at, Time received_at,
                        std::span<const std::byte> message) {
  const std::uint64_t log_time = nanoseconds(received_at, place.topic);
  const std::uint64_t publish_time = nanoseconds(measured_at, place.topic);
  writer_.write(channel_of(place), log_time, publish_time, message);
}

std::uint64_t TopicWriter::nanoseconds(Time time, const char* topic) const {
  const std::int64_t count = to_nanoseconds(time);
  if (count < 0) throw input_error(fmt::format("{}, {}", file_, topic), "a time lies before the epoch");
  return static_cast<std::uint64_t>(count);
}

std::uint16_t TopicWriter::channel_of(const Place& place) {
  const auto key = std::make_pair(std::string(place.topic), place.sensor_id);
  const auto found = channels_.find(key);
  if (found != channels_.end()) return found->second;
  return channels_[key] = add_channel(place);
}

std::uint16_t TopicWriter::add_channel(const Place& place) {
  const MessageSchema schema = schema_of(place.topic);
  if (!schemas_.contains(schema.name)) {
    schemas_[schema.name] = writer_.add_schema(schema.name, "protobuf", schema.descriptor_set);
  }
  mcap::StringMap metadata;
  if (place.sensor_id) metadata["sensor_id"] = std::to_string(*place.sensor_id);
  if (schema.is_osi) metadata["net.asam.osi.trace.channel.osi_version"] = kOsiVersion;
  const int group = topic::is_truth(place.topic) ? 1 : 0;
  return writer_.add_channel(place.topic, "protobuf", schemas_[schema.name], metadata, group);
}

}  // namespace lanefuse
