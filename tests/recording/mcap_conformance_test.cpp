// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// The MCAP project's conformance files: each must read as the JSON beside it says.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "recording/conformance_files.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/mcap_record_reader.hpp"
#include "support/files.hpp"
#include "support/real_data.hpp"
#include "support/sha256.hpp"

namespace lanefuse::mcap {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::string text_of(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

json number(std::uint64_t value) { return std::to_string(value); }

json list(const Bytes& bytes) {
  json values = json::array();
  for (const std::byte byte : bytes) {
    values.push_back(number(std::to_integer<std::uint64_t>(byte)));
  }
  return values;
}

json by_channel(const std::map<std::uint16_t, std::uint64_t>& map) {
  json values = json::object();
  for (const auto& [channel, value] : map) {
    values[std::to_string(channel)] = number(value);
  }
  return values;
}

using Fields = std::map<std::string, json>;

Fields fields_of(const Header& r) { return {{"library", r.library}, {"profile", r.profile}}; }
Fields fields_of(const Footer& r) {
  return {{"summary_crc", number(r.summary_crc)},
          {"summary_offset_start", number(r.summary_offset_start)},
          {"summary_start", number(r.summary_start)}};
}
Fields fields_of(const Schema& r) {
  return {{"data", list(r.data)}, {"encoding", r.encoding}, {"id", number(r.id)}, {"name", r.name}};
}
Fields fields_of(const Channel& r) {
  return {{"id", number(r.id)},
          {"message_encoding", r.message_encoding},
          {"metadata", json(r.metadata)},
          {"schema_id", number(r.schema_id)},
          {"topic", r.topic}};
}
Fields fields_of(const Message& r) {
  return {{"channel_id", number(r.channel_id)},
          {"data", list(r.data)},
          {"log_time", number(r.log_time)},
          {"publish_time", number(r.publish_time)},
          {"sequence", number(r.sequence)}};
}
Fields fields_of(const Attachment& r) {
  return {{"create_time", number(r.create_time)},
          {"data", list(r.data)},
          {"log_time", number(r.log_time)},
          {"media_type", r.media_type},
          {"name", r.name}};
}
Fields fields_of(const Metadata& r) { return {{"metadata", json(r.metadata)}, {"name", r.name}}; }
Fields fields_of(const DataEnd& r) { return {{"data_section_crc", number(r.data_section_crc)}}; }
Fields fields_of(const Statistics& r) {
  return {{"attachment_count", number(r.attachment_count)},
          {"channel_count", number(r.channel_count)},
          {"channel_message_counts", by_channel(r.channel_message_counts)},
          {"chunk_count", number(r.chunk_count)},
          {"message_count", number(r.message_count)},
          {"message_end_time", number(r.message_end_time)},
          {"message_start_time", number(r.message_start_time)},
          {"metadata_count", number(r.metadata_count)},
          {"schema_count", number(r.schema_count)}};
}
Fields fields_of(const ChunkIndex& r) {
  return {{"chunk_length", number(r.chunk_length)},
          {"chunk_start_offset", number(r.chunk_start_offset)},
          {"compressed_size", number(r.compressed_size)},
          {"compression", r.compression},
          {"message_end_time", number(r.message_end_time)},
          {"message_index_length", number(r.message_index_length)},
          {"message_index_offsets", by_channel(r.message_index_offsets)},
          {"message_start_time", number(r.message_start_time)},
          {"uncompressed_size", number(r.uncompressed_size)}};
}
Fields fields_of(const AttachmentIndex& r) {
  return {{"create_time", number(r.create_time)},
          {"data_size", number(r.data_size)},
          {"length", number(r.length)},
          {"log_time", number(r.log_time)},
          {"media_type", r.media_type},
          {"name", r.name},
          {"offset", number(r.offset)}};
}
Fields fields_of(const MetadataIndex& r) {
  return {{"length", number(r.length)}, {"name", r.name}, {"offset", number(r.offset)}};
}
Fields fields_of(const SummaryOffset& r) {
  return {{"group_length", number(r.group_length)},
          {"group_opcode", number(r.group_opcode)},
          {"group_start", number(r.group_start)}};
}

template <typename Record>
json render(const char* type, const RawRecord& raw) {
  const auto record = parse<Record>(raw.content);
  if (!record) {
    return std::string("cannot be parsed: ") + type;
  }
  json fields = json::array();
  for (const auto& [name, value] : fields_of(*record)) {
    fields.push_back(json::array({name, value}));
  }
  return {{"type", type}, {"fields", fields}};
}

json render(const RawRecord& raw) {
  switch (raw.opcode) {
    case Opcode::header:
      return render<Header>("Header", raw);
    case Opcode::footer:
      return render<Footer>("Footer", raw);
    case Opcode::schema:
      return render<Schema>("Schema", raw);
    case Opcode::channel:
      return render<Channel>("Channel", raw);
    case Opcode::message:
      return render<Message>("Message", raw);
    case Opcode::chunk:
      return "a chunk that was not unpacked";
    case Opcode::message_index:
      return "a message index";
    case Opcode::chunk_index:
      return render<ChunkIndex>("ChunkIndex", raw);
    case Opcode::attachment:
      return render<Attachment>("Attachment", raw);
    case Opcode::attachment_index:
      return render<AttachmentIndex>("AttachmentIndex", raw);
    case Opcode::statistics:
      return render<Statistics>("Statistics", raw);
    case Opcode::metadata:
      return render<Metadata>("Metadata", raw);
    case Opcode::metadata_index:
      return render<MetadataIndex>("MetadataIndex", raw);
    case Opcode::summary_offset:
      return render<SummaryOffset>("SummaryOffset", raw);
    case Opcode::data_end:
      return render<DataEnd>("DataEnd", raw);
  }
  return "an unknown record";
}

// The file itself; or, where the folder only has its sum and size, its bytes built from the JSON and compared
// with it.
Bytes published_bytes(const fs::path& file, const json& description) {
  const Bytes stored = testing::read_file(file);
  const std::string pointer = text_of(stored);
  const std::string oid = "oid sha256:";
  if (!pointer.starts_with("version https://git-lfs")) {
    return stored;
  }
  const Bytes built = testing::ConformanceBuilder::build(description);
  EXPECT_EQ(testing::Sha256::hex(built), pointer.substr(pointer.find(oid) + oid.size(), 64));
  return built;
}

void expect_records(const fs::path& file, const json& expected) {
  RecordReader reader(file);
  json records = json::array();
  while (const auto raw = reader.next()) {
    if (raw->opcode != Opcode::message_index) {
      records.push_back(render(*raw));
    }
  }
  EXPECT_EQ(records, expected);
}

void expect_messages(const fs::path& file, const json& records) {
  std::vector<json> expected;
  for (const json& record : records) {
    if (record.at("type") == "Message") {
      expected.push_back(record);
    }
  }
  std::stable_sort(expected.begin(), expected.end(), [](const json& a, const json& b) {
    return testing::JsonFields(a).number<int>("log_time") < testing::JsonFields(b).number<int>("log_time");
  });
  Reader reader(file);
  for (const json& record : expected) {
    const auto message = reader.next();
    ASSERT_TRUE(message);
    json fields = json::array();
    for (const auto& [name, value] : fields_of(*message)) {
      fields.push_back(json::array({name, value}));
    }
    EXPECT_EQ(fields, record.at("fields"));
    EXPECT_TRUE(reader.channels().contains(message->channel_id));
  }
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.damage().any) << reader.damage().first_place;
}

class McapConformance : public ::testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(McapConformance, FilesReadAsTheirJsonSays) {
  const auto [shape, count] = GetParam();
  const fs::path folder = testing::real_data("mcap_conformance") / shape;
  LANEFUSE_NEEDS_DATA(folder);
  const testing::TemporaryFolder scratch;
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".mcap") {
      continue;
    }
    SCOPED_TRACE(entry.path().filename().string());
    json description;
    std::ifstream(fs::path(entry.path()).replace_extension(".json")) >> description;
    const fs::path file = scratch / "file.mcap";
    testing::write_file(file, published_bytes(entry.path(), description));
    expect_records(file, description.at("records"));
    expect_messages(file, description.at("records"));
    ++seen;
  }
  EXPECT_EQ(seen, count);
}

INSTANTIATE_TEST_SUITE_P(Shapes, McapConformance,
                         ::testing::Values(std::pair("NoData", 6), std::pair("OneAttachment", 14),
                                           std::pair("OneMessage", 154), std::pair("OneMetadata", 14),
                                           std::pair("OneSchemalessMessage", 74),
                                           std::pair("TenMessages", 154)),
                         [](const auto& test) { return std::string(test.param.first); });

}  // namespace
}  // namespace lanefuse::mcap
