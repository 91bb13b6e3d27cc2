// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_writer.hpp"

#include <cassert>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "recording/mcap_chunk_builder.hpp"
#include "recording/mcap_encode.hpp"
#include "recording/mcap_format.hpp"
#include "recording/mcap_output_file.hpp"
#include "recording/mcap_writer_summary.hpp"

namespace lanefuse::mcap {
namespace {

// Half of what a reader takes: room for what compression adds to data that cannot be compressed.
constexpr std::uint64_t kMaxWritten = kMaxRecord / 2;

}  // namespace

class Writer::Session {
 public:
  Session(const std::filesystem::path& path, WriterConfig config)
      : config_(checked(std::move(config))), file_(path) {
    append(pending_, Header{config_.profile, config_.library});
    pending_.insert(pending_.begin(), kMagic.begin(), kMagic.end());
    flush();
  }

  std::uint16_t add_schema(Schema schema) {
    check_size(schema.data.size(), "schema " + schema.name);
    assert(summary_.schemas.size() < std::numeric_limits<std::uint16_t>::max());
    schema.id = static_cast<std::uint16_t>(summary_.schemas.size() + 1);
    summary_.schemas.push_back(std::move(schema));
    return summary_.schemas.back().id;
  }

  std::uint16_t add_channel(Channel channel, int group) {
    assert(channel.schema_id <= summary_.schemas.size());
    assert(summary_.channels.size() <= std::numeric_limits<std::uint16_t>::max());
    channel.id = static_cast<std::uint16_t>(summary_.channels.size());
    summary_.channels.push_back(std::move(channel));
    groups_.push_back(group);
    channel_written_.push_back(false);
    return summary_.channels.back().id;
  }

  [[nodiscard]] std::uint32_t next_sequence(std::uint16_t channel_id) const {
    const auto& counts = summary_.statistics.channel_message_counts;
    const auto count = counts.find(channel_id);
    return count == counts.end() ? 0 : static_cast<std::uint32_t>(count->second);
  }

  void write(const Message& head, std::span<const std::byte> data) {
    assert(head.channel_id < summary_.channels.size());
    check_size(data.size(), "message on " + summary_.channels[head.channel_id].topic);
    ChunkBuilder& chunk = chunks_[groups_[head.channel_id]];
    const bool full = chunk.size() + data.size() > config_.chunk_size ||
                      chunk.span_with(head.log_time) > config_.chunk_duration;
    if (full && !chunk.empty()) {
      finish(chunk);
    }
    introduce(head.channel_id);
    chunk.add(head, data);
    summary_.count(head);
  }

  void write(const Metadata& metadata) {
    const std::uint64_t offset = file_.size();
    append(pending_, metadata);
    check_size(pending_.size(), "metadata " + metadata.name);
    summary_.metadata.push_back({offset, pending_.size(), metadata.name});
    flush();
  }

  void write(const Attachment& attachment) {
    check_size(attachment.data.size(), "attachment " + attachment.name);
    const std::uint64_t offset = file_.size();
    append(pending_, attachment);
    summary_.attachments.push_back({offset, pending_.size(), attachment.log_time, attachment.create_time,
                                    attachment.data.size(), attachment.name, attachment.media_type});
    flush();
  }

  void close() {
    introduce_all();
    for (auto& [group, chunk] : chunks_) {
      finish(chunk);
    }
    append(pending_, DataEnd{file_.crc()});
    flush();
    summary_.statistics.schema_count = static_cast<std::uint16_t>(summary_.schemas.size());
    summary_.statistics.channel_count = static_cast<std::uint32_t>(summary_.channels.size());
    summary_.statistics.attachment_count = static_cast<std::uint32_t>(summary_.attachments.size());
    summary_.statistics.metadata_count = static_cast<std::uint32_t>(summary_.metadata.size());
    summary_.statistics.chunk_count = static_cast<std::uint32_t>(summary_.chunks.size());
    file_.write(encode_summary(summary_, file_.size()));
    file_.place();
  }

 private:
  static WriterConfig checked(WriterConfig config) {
    if (config.chunk_size == 0 || config.chunk_size > kMaxWritten) {
      throw configuration_error("chunk_size",
                                fmt::format("{} is not in 1 .. {}", config.chunk_size, kMaxWritten));
    }
    return config;
  }

  void check_size(std::uint64_t size, const std::string& what) const {
    if (size > kMaxWritten) {
      throw input_error(file_.path().string(),
                        fmt::format("{} has {} bytes, and {} is the limit", what, size, kMaxWritten));
    }
  }

  // Schema and channel come in the chunk of the first message that needs them, before it. A schema comes in
  // every group that needs it, for nobody knows whose chunk will be written first.
  void introduce(std::uint16_t channel_id) {
    if (channel_written_[channel_id]) {
      return;
    }
    const Channel& channel = summary_.channels[channel_id];
    const int group = groups_[channel_id];
    if (channel.schema_id != 0 && schemas_written_.emplace(group, channel.schema_id).second) {
      chunks_[group].add(summary_.schemas[channel.schema_id - 1U]);
    }
    chunks_[group].add(channel);
    channel_written_[channel_id] = true;
  }

  void introduce_all() {
    for (const Channel& channel : summary_.channels) {
      introduce(channel.id);
    }
  }

  void finish(ChunkBuilder& chunk) {
    if (!chunk.empty()) {
      summary_.chunks.push_back(chunk.finish(config_.compression, file_.size(), pending_));
      flush();
    }
  }

  void flush() {
    file_.write(pending_);
    pending_.clear();
  }

  WriterConfig config_;
  OutputFile file_;
  std::map<int, ChunkBuilder> chunks_;  // by group
  Bytes pending_;
  WrittenSummary summary_;
  std::vector<int> groups_;                                  // of the channels
  std::set<std::pair<int, std::uint16_t>> schemas_written_;  // by group
  std::vector<bool> channel_written_;
};

Writer::Writer(const std::filesystem::path& path, WriterConfig config)
    : session_(std::make_unique<Session>(path, std::move(config))) {}
Writer::~Writer() = default;
Writer::Writer(Writer&&) noexcept = default;
Writer& Writer::operator=(Writer&&) noexcept = default;

std::uint16_t Writer::add_schema(const std::string& name, const std::string& encoding,
                                 std::span<const std::byte> data) {
  return session_->add_schema({0, name, encoding, {data.begin(), data.end()}});
}

std::uint16_t Writer::add_channel(const std::string& topic, const std::string& message_encoding,
                                  std::uint16_t schema_id, StringMap metadata, int group) {
  return session_->add_channel({0, schema_id, topic, message_encoding, std::move(metadata)}, group);
}

void Writer::write(std::uint16_t channel_id, std::uint64_t log_time, std::uint64_t publish_time,
                   std::span<const std::byte> data) {
  session_->write({channel_id, session_->next_sequence(channel_id), log_time, publish_time, {}}, data);
}

void Writer::write(const Message& message) { session_->write(message, message.data); }
void Writer::write(const Metadata& metadata) { session_->write(metadata); }
void Writer::write(const Attachment& attachment) { session_->write(attachment); }

void Writer::close() {
  session_->close();
  session_.reset();
}

}  // namespace lanefuse::mcap
