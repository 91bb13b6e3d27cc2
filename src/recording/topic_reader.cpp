// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/topic_reader.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/message_schema.hpp"

namespace lanefuse {

TopicReader::TopicReader(const std::filesystem::path& path, RecordingHead::Kind kind)
    : file_(path.string()), reader_(path), head_(read_head(reader_.metadata(), kind, file_)) {
  for (const auto& [id, channel] : reader_.channels()) check(channel);
}

void TopicReader::check(const mcap::Channel& channel) const {
  const std::string expected = schema_name_of(channel.topic);
  if (expected.empty()) return;
  const auto schema = reader_.schemas().find(channel.schema_id);
  const std::string found = schema == reader_.schemas().end() ? "nothing" : schema->second.name;
  if (found != expected || channel.message_encoding != "protobuf") {
    throw input_error(file_,
                      fmt::format("channel {} carries {}, encoded as \"{}\"", channel.topic, found,
                                  channel.message_encoding),
                      fmt::format("it must carry {} as protobuf", expected));
  }
}

ReadReport TopicReader::report() const {
  const mcap::Damage& damage = reader_.damage();
  ReadReport report;
  report.first_problem = damage.any ? damage.first_place : first_refusal_;
  report.chunks_lost = damage.chunks_lost;
  report.records_lost = damage.records_lost;
  report.messages_refused = refused_;
  report.bytes_skipped = damage.bytes_skipped;
  return report;
}

void TopicReader::select(const std::function<bool(std::string_view)>& wanted) {
  reader_.select([&](const mcap::Channel& channel) { return wanted(channel.topic); });
}

bool TopicReader::next() {
  while (reader_.next(message_)) {
    if (message_.log_time <= std::numeric_limits<std::int64_t>::max() &&
        message_.publish_time <= std::numeric_limits<std::int64_t>::max()) {
      return true;
    }
    refuse("a time after the year 2262");
  }
  return false;
}

const mcap::Channel& TopicReader::channel() const { return reader_.channels().at(message_.channel_id); }

Time TopicReader::log_time() const { return from_nanoseconds(static_cast<std::int64_t>(message_.log_time)); }

bool TopicReader::has(std::string_view topic) const {
  return std::any_of(channels().begin(), channels().end(),
                     [topic](const auto& entry) { return entry.second.topic == topic; });
}

void TopicReader::refuse(const std::string& problem) {
  ++refused_;
  if (!first_refusal_.empty()) return;
  first_refusal_ = fmt::format("{}, message at {} ns: {}", channel().topic, message_.log_time, problem);
}

}  // namespace lanefuse
