// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace lanefuse::mcap {

/// The records of an MCAP file (specification: mcap.dev), as plain data. Field names are the specification's.
using Bytes = std::vector<std::byte>;
using StringMap = std::map<std::string, std::string>;

struct Header {
  std::string profile;
  std::string library;

  bool operator==(const Header&) const = default;
};

struct Footer {
  std::uint64_t summary_start = 0;
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;
};

struct Schema {
  std::uint16_t id = 0;  ///< never 0
  std::string name;
  std::string encoding;
  Bytes data;

  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  ///< 0: none
  std::string topic;
  std::string message_encoding;
  StringMap metadata;

  bool operator==(const Channel&) const = default;
};

struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;      ///< [ns]
  std::uint64_t publish_time = 0;  ///< [ns]
  Bytes data;

  bool operator==(const Message&) const = default;
};

struct Attachment {
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::string name;
  std::string media_type;
  Bytes data;

  bool operator==(const Attachment&) const = default;
};

struct Metadata {
  std::string name;
  StringMap metadata;

  bool operator==(const Metadata&) const = default;
};

/// Messages and their schemas and channels, packed: `records` as stored in the file.
struct Chunk {
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: absent
  std::string compression;             ///< "", "lz4" or "zstd"
  std::span<const std::byte> records;  ///< as stored; a view of the bytes the chunk was parsed from
};

/// Where the messages of one channel lie in the chunk before it.
struct MessageIndex {
  struct Entry {
    std::uint64_t log_time = 0;
    std::uint64_t offset = 0;  ///< in the uncompressed records
  };
  std::uint16_t channel_id = 0;
  std::vector<Entry> records;
};

struct ChunkIndex {
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::uint64_t chunk_start_offset = 0;
  std::uint64_t chunk_length = 0;  ///< of the whole record, opcode and length included
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};

struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< of the whole record
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
};

struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
};

struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};

struct SummaryOffset {
  std::uint8_t group_opcode = 0;
  std::uint64_t group_start = 0;
  std::uint64_t group_length = 0;
};

struct DataEnd {
  std::uint32_t data_section_crc = 0;  ///< 0: absent
};

}  // namespace lanefuse::mcap
