// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_parse.hpp"

#include "recording/mcap_crc32.hpp"
#include "recording/mcap_cursor.hpp"

namespace lanefuse::mcap {
namespace {

// Braced initialisers are evaluated from left to right: the fields below are in the order of the file.

Header take(Cursor& in, const Header*) { return {in.text(), in.text()}; }

Footer take(Cursor& in, const Footer*) {
  return {in.integer<std::uint64_t>(), in.integer<std::uint64_t>(), in.integer<std::uint32_t>()};
}

Schema take(Cursor& in, const Schema*) {
  Schema schema{in.integer<std::uint16_t>(), in.text(), in.text(),
                to_bytes(in.take(in.integer<std::uint32_t>()))};
  if (schema.id == 0) {
    in.fail();
  }
  return schema;
}

Channel take(Cursor& in, const Channel*) {
  return {in.integer<std::uint16_t>(), in.integer<std::uint16_t>(), in.text(), in.text(), in.text_map()};
}

Message take_head(Cursor& in) {
  return {in.integer<std::uint16_t>(),
          in.integer<std::uint32_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          {}};
}

Message take(Cursor& in, const Message*) {
  Message message = take_head(in);
  message.data = to_bytes(in.take(in.left()));
  return message;
}

Chunk take(Cursor& in, const Chunk*) {
  return {in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint32_t>(),
          in.text(),
          in.take(in.integer<std::uint64_t>())};
}

MessageIndex take(Cursor& in, const MessageIndex*) {
  MessageIndex index{in.integer<std::uint16_t>(), {}};
  in.pairs([&index](Cursor& pair) {
    index.records.push_back({pair.integer<std::uint64_t>(), pair.integer<std::uint64_t>()});
  });
  return index;
}

// Counts or offsets by channel, as they appear in two records.
std::map<std::uint16_t, std::uint64_t> take_by_channel(Cursor& in) {
  std::map<std::uint16_t, std::uint64_t> by_channel;
  in.pairs([&by_channel](Cursor& pair) {
    const auto channel = pair.integer<std::uint16_t>();
    by_channel.insert_or_assign(channel, pair.integer<std::uint64_t>());
  });
  return by_channel;
}

ChunkIndex take(Cursor& in, const ChunkIndex*) {
  return {in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          take_by_channel(in),
          in.integer<std::uint64_t>(),
          in.text(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>()};
}

Attachment take(Cursor& in, const Attachment*) {
  return {in.integer<std::uint64_t>(), in.integer<std::uint64_t>(), in.text(), in.text(),
          to_bytes(in.take(in.integer<std::uint64_t>()))};
}

AttachmentIndex take(Cursor& in, const AttachmentIndex*) {
  return {in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.integer<std::uint64_t>(),
          in.text(),
          in.text()};
}

Metadata take(Cursor& in, const Metadata*) { return {in.text(), in.text_map()}; }

MetadataIndex take(Cursor& in, const MetadataIndex*) {
  return {in.integer<std::uint64_t>(), in.integer<std::uint64_t>(), in.text()};
}

Statistics take(Cursor& in, const Statistics*) {
  return {in.integer<std::uint64_t>(), in.integer<std::uint16_t>(), in.integer<std::uint32_t>(),
          in.integer<std::uint32_t>(), in.integer<std::uint32_t>(), in.integer<std::uint32_t>(),
          in.integer<std::uint64_t>(), in.integer<std::uint64_t>(), take_by_channel(in)};
}

SummaryOffset take(Cursor& in, const SummaryOffset*) {
  return {in.integer<std::uint8_t>(), in.integer<std::uint64_t>(), in.integer<std::uint64_t>()};
}

DataEnd take(Cursor& in, const DataEnd*) { return {in.integer<std::uint32_t>()}; }

}  // namespace

template <typename Record>
std::optional<Record> parse(std::span<const std::byte> content) {
  Cursor in(content);
  Record record = take(in, static_cast<const Record*>(nullptr));
  return in.ok() ? std::optional(std::move(record)) : std::nullopt;
}

template <>
std::optional<Attachment> parse<Attachment>(std::span<const std::byte> content) {
  Cursor in(content);
  Attachment attachment = take(in, static_cast<const Attachment*>(nullptr));
  const auto covered = content.first(content.size() - in.left());
  const auto crc = in.integer<std::uint32_t>();
  const bool sound = in.ok() && (crc == 0 || crc == crc32(covered));
  return sound ? std::optional(std::move(attachment)) : std::nullopt;
}

template std::optional<Header> parse<Header>(std::span<const std::byte>);
template std::optional<Footer> parse<Footer>(std::span<const std::byte>);
template std::optional<Schema> parse<Schema>(std::span<const std::byte>);
template std::optional<Channel> parse<Channel>(std::span<const std::byte>);
template std::optional<Message> parse<Message>(std::span<const std::byte>);
template std::optional<Chunk> parse<Chunk>(std::span<const std::byte>);
template std::optional<MessageIndex> parse<MessageIndex>(std::span<const std::byte>);
template std::optional<ChunkIndex> parse<ChunkIndex>(std::span<const std::byte>);
template std::optional<AttachmentIndex> parse<AttachmentIndex>(std::span<const std::byte>);
template std::optional<Metadata> parse<Metadata>(std::span<const std::byte>);
template std::optional<MetadataIndex> parse<MetadataIndex>(std::span<const std::byte>);
template std::optional<Statistics> parse<Statistics>(std::span<const std::byte>);
template std::optional<SummaryOffset> parse<SummaryOffset>(std::span<const std::byte>);
template std::optional<DataEnd> parse<DataEnd>(std::span<const std::byte>);

std::optional<Message> parse_message_head(std::span<const std::byte> content) {
  Cursor in(content);
  Message message = take_head(in);
  return in.ok() ? std::optional(std::move(message)) : std::nullopt;
}

std::optional<AttachmentIndex> parse_attachment_head(std::span<const std::byte> content) {
  Cursor in(content);
  AttachmentIndex entry;
  entry.log_time = in.integer<std::uint64_t>();
  entry.create_time = in.integer<std::uint64_t>();
  entry.name = in.text();
  entry.media_type = in.text();
  entry.data_size = in.integer<std::uint64_t>();
  return in.ok() ? std::optional(std::move(entry)) : std::nullopt;
}

std::optional<RawRecord> record_at(std::span<const std::byte> records, std::uint64_t offset) {
  Cursor in(records.subspan(offset));
  const auto opcode = static_cast<Opcode>(in.integer<std::uint8_t>());
  const auto content = in.take(in.integer<std::uint64_t>());
  return in.ok() ? std::optional(RawRecord{opcode, offset, content}) : std::nullopt;
}

}  // namespace lanefuse::mcap
