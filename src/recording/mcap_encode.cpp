// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_encode.hpp"

#include <concepts>
#include <string_view>

#include "recording/mcap_crc32.hpp"
#include "recording/mcap_format.hpp"

namespace lanefuse::mcap {
namespace {

// One record at the end of a buffer. Lengths that come before what they measure are filled in afterwards.
class Encoder {
 public:
  Encoder(Bytes& out, Opcode opcode) : out_(out) {
    integer(static_cast<std::uint8_t>(opcode));
    integer(std::uint64_t{0});
    content_ = out_.size();
  }
  ~Encoder() { fill_in<std::uint64_t>(content_ - sizeof(std::uint64_t), out_.size() - content_); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  template <std::unsigned_integral T>
  Encoder& integer(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      out_.push_back(static_cast<std::byte>(value >> (8 * i)));
    }
    return *this;
  }

  Encoder& raw(std::span<const std::byte> bytes) {
    out_.insert(out_.end(), bytes.begin(), bytes.end());
    return *this;
  }

  Encoder& text(std::string_view text) {
    return integer(static_cast<std::uint32_t>(text.size())).raw(std::as_bytes(std::span(text)));
  }

  // `append_pair` writes one element of `pairs`.
  template <typename Pairs, typename AppendPair>
  Encoder& pairs(const Pairs& pairs, AppendPair append_pair) {
    integer(std::uint32_t{0});
    const std::size_t begin = out_.size();
    for (const auto& [key, value] : pairs) {
      append_pair(key, value);
    }
    fill_in<std::uint32_t>(begin - sizeof(std::uint32_t), out_.size() - begin);
    return *this;
  }

  Encoder& text_map(const StringMap& map) {
    return pairs(map, [this](const std::string& key, const std::string& value) { text(key).text(value); });
  }

  Encoder& by_channel(const std::map<std::uint16_t, std::uint64_t>& map) {
    return pairs(map,
                 [this](std::uint16_t channel, std::uint64_t value) { integer(channel).integer(value); });
  }

  [[nodiscard]] std::span<const std::byte> content() const { return std::span(out_).subspan(content_); }

 private:
  template <std::unsigned_integral T>
  void fill_in(std::size_t at, std::size_t value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      out_[at + i] = static_cast<std::byte>(value >> (8 * i));
    }
  }

  Bytes& out_;
  std::size_t content_ = 0;
};

}  // namespace

void append(Bytes& out, const Header& header) {
  Encoder(out, Opcode::header).text(header.profile).text(header.library);
}

void append(Bytes& out, const Footer& footer) {
  Encoder(out, Opcode::footer)
      .integer(footer.summary_start)
      .integer(footer.summary_offset_start)
      .integer(footer.summary_crc);
}

void append(Bytes& out, const Schema& schema) {
  Encoder(out, Opcode::schema)
      .integer(schema.id)
      .text(schema.name)
      .text(schema.encoding)
      .integer(static_cast<std::uint32_t>(schema.data.size()))
      .raw(schema.data);
}

void append(Bytes& out, const Channel& channel) {
  Encoder(out, Opcode::channel)
      .integer(channel.id)
      .integer(channel.schema_id)
      .text(channel.topic)
      .text(channel.message_encoding)
      .text_map(channel.metadata);
}

void append(Bytes& out, const Message& message) { append(out, message, message.data); }

void append(Bytes& out, const Message& head, std::span<const std::byte> data) {
  Encoder(out, Opcode::message)
      .integer(head.channel_id)
      .integer(head.sequence)
      .integer(head.log_time)
      .integer(head.publish_time)
      .raw(data);
}

void append(Bytes& out, const Chunk& chunk) {
  Encoder(out, Opcode::chunk)
      .integer(chunk.message_start_time)
      .integer(chunk.message_end_time)
      .integer(chunk.uncompressed_size)
      .integer(chunk.uncompressed_crc)
      .text(chunk.compression)
      .integer(static_cast<std::uint64_t>(chunk.records.size()))
      .raw(chunk.records);
}

void append(Bytes& out, const MessageIndex& index) {
  Encoder record(out, Opcode::message_index);
  record.integer(index.channel_id).pairs(index.records, [&record](std::uint64_t time, std::uint64_t offset) {
    record.integer(time).integer(offset);
  });
}

void append(Bytes& out, const ChunkIndex& index) {
  Encoder(out, Opcode::chunk_index)
      .integer(index.message_start_time)
      .integer(index.message_end_time)
      .integer(index.chunk_start_offset)
      .integer(index.chunk_length)
      .by_channel(index.message_index_offsets)
      .integer(index.message_index_length)
      .text(index.compression)
      .integer(index.compressed_size)
      .integer(index.uncompressed_size);
}

void append(Bytes& out, const Attachment& attachment) {
  Encoder record(out, Opcode::attachment);
  record.integer(attachment.log_time)
      .integer(attachment.create_time)
      .text(attachment.name)
      .text(attachment.media_type)
      .integer(static_cast<std::uint64_t>(attachment.data.size()))
      .raw(attachment.data);
  record.integer(crc32(record.content()));
}

void append(Bytes& out, const AttachmentIndex& index) {
  Encoder(out, Opcode::attachment_index)
      .integer(index.offset)
      .integer(index.length)
      .integer(index.log_time)
      .integer(index.create_time)
      .integer(index.data_size)
      .text(index.name)
      .text(index.media_type);
}

void append(Bytes& out, const Metadata& metadata) {
  Encoder(out, Opcode::metadata).text(metadata.name).text_map(metadata.metadata);
}

void append(Bytes& out, const MetadataIndex& index) {
  Encoder(out, Opcode::metadata_index).integer(index.offset).integer(index.length).text(index.name);
}

void append(Bytes& out, const Statistics& statistics) {
  Encoder(out, Opcode::statistics)
      .integer(statistics.message_count)
      .integer(statistics.schema_count)
      .integer(statistics.channel_count)
      .integer(statistics.attachment_count)
      .integer(statistics.metadata_count)
      .integer(statistics.chunk_count)
      .integer(statistics.message_start_time)
      .integer(statistics.message_end_time)
      .by_channel(statistics.channel_message_counts);
}

void append(Bytes& out, const SummaryOffset& offset) {
  Encoder(out, Opcode::summary_offset)
      .integer(offset.group_opcode)
      .integer(offset.group_start)
      .integer(offset.group_length);
}

void append(Bytes& out, const DataEnd& data_end) {
  Encoder(out, Opcode::data_end).integer(data_end.data_section_crc);
}

}  // namespace lanefuse::mcap
