// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/message_schema.hpp"

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include "recording/mcap_reader.hpp"
#include "recording/topics.hpp"
#include "small_drive.hpp"
#include "support/files.hpp"

namespace lanefuse {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptorSet;

/// What a reader that knows nothing of the message makes of its schema; null where it cannot.
const Descriptor* built(const mcap::Schema& schema, DescriptorPool& pool) {
  FileDescriptorSet set;
  if (!set.ParseFromArray(schema.data.data(), static_cast<int>(schema.data.size()))) return nullptr;
  for (const auto& file : set.file()) {
    if (!pool.BuildFile(file)) return nullptr;
  }
  return pool.FindMessageTypeByName(schema.name);
}

TEST(MessageSchema, EveryChannelOfADriveDescribesItself) {
  const testing::TemporaryFolder folder;
  testing::write_drive(folder / "drive.mcap", 2);
  const mcap::Reader reader(folder / "drive.mcap");
  EXPECT_EQ(reader.channels().size(), 11u);
  for (const auto& [id, channel] : reader.channels()) {
    const mcap::Schema& schema = reader.schemas().at(channel.schema_id);
    DescriptorPool pool;
    EXPECT_EQ(schema.encoding, "protobuf");
    EXPECT_NE(built(schema, pool), nullptr) << channel.topic << " as " << schema.name;
  }
}

TEST(MessageSchema, OsiMessagesKeepOsisNumbers) {
  const auto number_of = [](const char* topic, const char* field) {
    const MessageSchema schema = schema_of(topic);
    DescriptorPool pool;
    return built({1, schema.name, "protobuf", schema.descriptor_set}, pool)->FindFieldByName(field)->number();
  };
  EXPECT_EQ(number_of(topic::kVehicleMotion, "vehicle_motion"), 13);
  EXPECT_EQ(number_of(topic::kObjects, "moving_object"), 13);
  EXPECT_EQ(number_of(topic::kLaneBoundaries, "lane_boundary"), 21);
  EXPECT_EQ(number_of(topic::kTrueRoad, "lane_boundary"), 9);
}

TEST(MessageSchema, OsiIsDeclaredAsItAsks) {
  const testing::TemporaryFolder folder;
  testing::write_drive(folder / "drive.mcap", 1);
  const mcap::Reader reader(folder / "drive.mcap");
  const auto is_trace = [](const mcap::Metadata& record) { return record.name == "net.asam.osi.trace"; };
  const auto trace = std::find_if(reader.metadata().begin(), reader.metadata().end(), is_trace);
  ASSERT_NE(trace, reader.metadata().end());
  EXPECT_EQ(trace->metadata.at("version"), "3.8.0");
  for (const auto& [id, channel] : reader.channels()) {
    const bool is_osi = reader.schemas().at(channel.schema_id).name.starts_with("osi3.");
    EXPECT_EQ(channel.metadata.contains("net.asam.osi.trace.channel.osi_version"), is_osi) << channel.topic;
  }
}

}  // namespace
}  // namespace lanefuse
