// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "recording/mcap_crc32.hpp"
#include "recording/mcap_encode.hpp"
#include "recording/mcap_format.hpp"
#include "support/files.hpp"

namespace lanefuse::testing {

/// The fields of one record as the conformance files' JSON has them: numbers as decimal text, bytes as lists
/// of them.
class JsonFields {
 public:
  explicit JsonFields(const nlohmann::json& record) {
    for (const auto& field : record.at("fields")) {
      fields_[field.at(0)] = field.at(1);
    }
  }

  template <typename T>
  [[nodiscard]] T number(const std::string& name) const {
    return static_cast<T>(std::stoull(fields_.at(name).get<std::string>()));
  }
  [[nodiscard]] std::string text(const std::string& name) const { return fields_.at(name); }
  [[nodiscard]] mcap::StringMap text_map(const std::string& name) const { return fields_.at(name); }
  [[nodiscard]] mcap::Bytes bytes(const std::string& name) const {
    mcap::Bytes bytes;
    for (const auto& value : fields_.at(name)) {
      bytes.push_back(static_cast<std::byte>(std::stoul(value.get<std::string>())));
    }
    return bytes;
  }
  [[nodiscard]] std::map<std::uint16_t, std::uint64_t> by_channel(const std::string& name) const {
    std::map<std::uint16_t, std::uint64_t> counts;
    for (const auto& [key, value] : fields_.at(name).items()) {
      counts[static_cast<std::uint16_t>(std::stoul(key))] = std::stoull(value.get<std::string>());
    }
    return counts;
  }

 private:
  std::map<std::string, nlohmann::json> fields_;
};

/// Builds the bytes of a conformance file from its JSON, for data folders that hold only the files' sums (as
/// a clone without large files does): the published SHA-256 then says whether the bytes are the published
/// ones.
class ConformanceBuilder {
 public:
  static mcap::Bytes build(const nlohmann::json& description) {
    ConformanceBuilder builder(description);
    for (const auto& record : description.at("records")) {
      builder.add(record.at("type"), JsonFields(record));
    }
    builder.out_.insert(builder.out_.end(), mcap::kMagic.begin(), mcap::kMagic.end());
    return builder.out_;
  }

 private:
  explicit ConformanceBuilder(const nlohmann::json& description)
      : features_(description.at("meta").at("variant").at("features").get<std::set<std::string>>()),
        out_(mcap::kMagic.begin(), mcap::kMagic.end()) {}

  // A record with what the feature "pad" adds: bytes after the fields that version 0 knows.
  template <typename Record>
  void append_padded(const Record& record) {
    mcap::Bytes bytes;
    append(bytes, record);
    if (features_.contains("pad")) {
      bytes.insert(bytes.end(), {std::byte{0x01}, std::byte{0xff}, std::byte{0xff}});
      bytes[1] = static_cast<std::byte>(bytes.size() - mcap::kRecordHeadSize);
    }
    out_.insert(out_.end(), bytes.begin(), bytes.end());
  }

  // In the chunk, if there is one and the data section has not ended.
  template <typename Record>
  void append_description(const Record& record) {
    if (features_.contains("ch") && !after_data_) {
      append(chunk_, record);
    } else {
      append_padded(record);
    }
  }

  void add_message(const mcap::Message& message) {
    if (!features_.contains("ch")) {
      return append(out_, message);
    }
    index_.channel_id = message.channel_id;
    index_.records.push_back({message.log_time, chunk_.size()});
    append(chunk_, message);
  }

  void end_data(const mcap::DataEnd& data_end) {
    if (!chunk_.empty()) {
      const auto [first, last] =
          std::minmax_element(index_.records.begin(), index_.records.end(),
                              [](const auto& a, const auto& b) { return a.log_time < b.log_time; });
      append(out_,
             mcap::Chunk{first->log_time, last->log_time, chunk_.size(), mcap::crc32(chunk_), "", chunk_});
      if (features_.contains("mx")) {
        append_padded(index_);
      }
    }
    append(out_, data_end);
    after_data_ = true;
  }

  void add(const std::string& type, const JsonFields& in);
  void add_to_summary(const std::string& type, const JsonFields& in);

  std::set<std::string> features_;
  mcap::Bytes out_;
  mcap::Bytes chunk_;
  mcap::MessageIndex index_;
  bool after_data_ = false;
};

inline void ConformanceBuilder::add(const std::string& type, const JsonFields& in) {
  if (type == "Header") {
    append_padded(mcap::Header{in.text("profile"), in.text("library")});
  } else if (type == "Schema") {
    append_description(
        mcap::Schema{in.number<std::uint16_t>("id"), in.text("name"), in.text("encoding"), in.bytes("data")});
  } else if (type == "Channel") {
    append_description(mcap::Channel{in.number<std::uint16_t>("id"), in.number<std::uint16_t>("schema_id"),
                                     in.text("topic"), in.text("message_encoding"), in.text_map("metadata")});
  } else if (type == "Message") {
    add_message({in.number<std::uint16_t>("channel_id"), in.number<std::uint32_t>("sequence"),
                 in.number<std::uint64_t>("log_time"), in.number<std::uint64_t>("publish_time"),
                 in.bytes("data")});
  } else if (type == "Attachment") {
    append_padded(mcap::Attachment{in.number<std::uint64_t>("log_time"),
                                   in.number<std::uint64_t>("create_time"), in.text("name"),
                                   in.text("media_type"), in.bytes("data")});
  } else if (type == "Metadata") {
    append_padded(mcap::Metadata{in.text("name"), in.text_map("metadata")});
  } else if (type == "DataEnd") {
    end_data({in.number<std::uint32_t>("data_section_crc")});
  } else if (type == "Footer") {
    append(out_, mcap::Footer{in.number<std::uint64_t>("summary_start"),
                              in.number<std::uint64_t>("summary_offset_start"),
                              in.number<std::uint32_t>("summary_crc")});
  } else {
    add_to_summary(type, in);
  }
}

inline void ConformanceBuilder::add_to_summary(const std::string& type, const JsonFields& in) {
  const auto u64 = [&in](const char* name) { return in.number<std::uint64_t>(name); };
  const auto u32 = [&in](const char* name) { return in.number<std::uint32_t>(name); };
  if (type == "Statistics") {
    append_padded(mcap::Statistics{u64("message_count"), in.number<std::uint16_t>("schema_count"),
                                   u32("channel_count"), u32("attachment_count"), u32("metadata_count"),
                                   u32("chunk_count"), u64("message_start_time"), u64("message_end_time"),
                                   in.by_channel("channel_message_counts")});
  } else if (type == "ChunkIndex") {
    append_padded(mcap::ChunkIndex{u64("message_start_time"), u64("message_end_time"),
                                   u64("chunk_start_offset"), u64("chunk_length"),
                                   in.by_channel("message_index_offsets"), u64("message_index_length"),
                                   in.text("compression"), u64("compressed_size"), u64("uncompressed_size")});
  } else if (type == "AttachmentIndex") {
    append_padded(mcap::AttachmentIndex{u64("offset"), u64("length"), u64("log_time"), u64("create_time"),
                                        u64("data_size"), in.text("name"), in.text("media_type")});
  } else if (type == "MetadataIndex") {
    append_padded(mcap::MetadataIndex{u64("offset"), u64("length"), in.text("name")});
  } else if (type == "SummaryOffset") {
    append_padded(mcap::SummaryOffset{in.number<std::uint8_t>("group_opcode"), u64("group_start"),
                                      u64("group_length")});
  } else {
    throw std::runtime_error("a record that nobody knows: " + type);
  }
}

}  // namespace lanefuse::testing
