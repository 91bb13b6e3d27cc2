// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "recording/mcap_crc32.hpp"
#include "recording/mcap_record_reader.hpp"
#include "recording/mcap_samples.hpp"
#include "support/files.hpp"

namespace lanefuse::mcap {
namespace {

using lanefuse::testing::TemporaryFolder;

constexpr std::array kCompressions{Compression::none, Compression::lz4, Compression::zstd};

TEST(McapCrc32, IsTheCommonCrc) {
  // The check value that every catalogue of CRCs lists for this one.
  EXPECT_EQ(crc32(bytes_of("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32(bytes_of("6789"), crc32(bytes_of("12345"))), 0xCBF43926U);
  EXPECT_EQ(crc32({}), 0U);
}

TEST(McapRoundTrip, GivesBackAllThatWasWritten) {
  for (const Compression compression : kCompressions) {
    const TemporaryFolder folder;
    write_sample(folder / "a.mcap", 20,
                 {.compression = compression, .chunk_size = 200, .profile = "p", .library = "l"});
    Reader reader(folder / "a.mcap");
    EXPECT_EQ(reader.header(), (Header{"p", "l"}));
    ASSERT_EQ(reader.schemas().size(), 1U);
    EXPECT_EQ(reader.schemas().at(1), (Schema{1, "test.Text", "text", bytes_of("any text")}));
    EXPECT_EQ(reader.channels().at(0), (Channel{0, 1, "/even", "text", {{"unit", "m"}}}));
    EXPECT_EQ(reader.channels().at(1), (Channel{1, 0, "/odd", "text", {}}));
    ASSERT_EQ(reader.metadata().size(), 1U);
    EXPECT_EQ(reader.metadata()[0], (Metadata{"about", {{"seed", "1"}, {"title", "a sample"}}}));
    ASSERT_EQ(reader.attachments().size(), 1U);
    EXPECT_EQ(reader.read_attachment(reader.attachments()[0]),
              (Attachment{7, 8, "note.txt", "text/plain", bytes_of("attached")}));
    const auto messages = read_all(reader);
    ASSERT_EQ(messages.size(), 20U);
    EXPECT_EQ(messages[5], (Message{1, 2, 5'000'000, 5'000'005, bytes_of("message 5")}));
    EXPECT_FALSE(reader.damage().any) << reader.damage().first_place;
  }
}

TEST(McapRoundTrip, SameCallsGiveSameBytes) {
  const TemporaryFolder folder;
  write_sample(folder / "a.mcap", 50, {.chunk_size = 300});
  write_sample(folder / "b.mcap", 50, {.chunk_size = 300});
  EXPECT_EQ(testing::read_file(folder / "a.mcap"), testing::read_file(folder / "b.mcap"));
}

TEST(McapRoundTrip, ChunksEndAtSizeAndDuration) {
  const TemporaryFolder folder;
  const auto chunks = [&folder](const WriterConfig& config) {
    write_sample(folder / "a.mcap", 100, config);
    RecordReader reader(folder / "a.mcap", RecordReader::Chunks::whole);
    int count = 0;
    while (const auto record = reader.next()) {
      count += record->opcode == Opcode::chunk ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(chunks({}), 1);
  EXPECT_GT(chunks({.chunk_size = 1000}), 3);
  EXPECT_EQ(chunks({.chunk_duration = 9'000'000}), 10);
}

TEST(McapRoundTrip, WhatIsAllZerosCanBeReadAgain) {
  // Packed a million zeros become so small that the reader's limit of compression would refuse them.
  const TemporaryFolder folder;
  Writer writer(folder / "a.mcap");
  writer.write(writer.add_channel("/a", "text", 0), 1, 1, Bytes(1'000'000));
  writer.close();
  EXPECT_EQ(read_all(folder / "a.mcap").at(0).data, Bytes(1'000'000));
}

TEST(McapRoundTrip, MoreOverlapThanFitsInMemoryIsMergedAllTheSame) {
  // 20 chunks of 16 MB unpacked, all with messages at 0 and 1000: more than the reader keeps at once.
  const TemporaryFolder folder;
  Writer writer(folder / "a.mcap", {.compression = Compression::lz4, .chunk_size = 17'000'000});
  const auto channel = writer.add_channel("/a", "text", 0);
  Bytes data(8'000'000);
  for (std::size_t i = 0; i < data.size(); i += 100) {
    data[i] = static_cast<std::byte>(i / 100);
  }
  for (int i = 0; i < 20; ++i) {
    writer.write(channel, 0, 0, data);
    writer.write(channel, 1000, 1000, data);
  }
  writer.close();
  Reader reader(folder / "a.mcap");
  Message message;
  for (std::uint32_t i = 0; i < 40; ++i) {
    ASSERT_TRUE(reader.next(message));
    EXPECT_EQ(message.log_time, i < 20 ? 0U : 1000U);
    EXPECT_EQ(message.sequence, i < 20 ? 2 * i : 2 * (i - 20) + 1);
  }
  EXPECT_FALSE(reader.next(message));
  EXPECT_FALSE(reader.damage().any) << reader.damage().first_place;
}

TEST(McapRoundTrip, SelectGivesOnlyTheChannelsAskedFor) {
  const TemporaryFolder folder;
  write_sample(folder / "a.mcap", 40, {.chunk_size = 200});
  Reader reader(folder / "a.mcap");
  reader.select([](const Channel& channel) { return channel.topic == "/odd"; });
  const auto odd = read_all(reader);
  EXPECT_EQ(odd.size(), 20U);
  EXPECT_TRUE(std::all_of(odd.begin(), odd.end(), [](const Message& m) { return m.channel_id == 1; }));
  reader.select([](const Channel&) { return true; });
  EXPECT_EQ(read_all(reader).size(), 40U);
}

TEST(McapRoundTrip, ChunksWithoutTheChannelAreNeverOpened) {
  const TemporaryFolder folder;
  {
    Writer writer(folder / "a.mcap", {.compression = Compression::none, .chunk_duration = 0});
    const auto first = writer.add_channel("/first", "text", 0);
    const auto second = writer.add_channel("/second", "text", 0);
    writer.write(first, 1, 1, bytes_of("to be damaged"));
    writer.write(second, 2, 2, bytes_of("sound"));
    writer.close();
  }
  auto bytes = testing::read_file(folder / "a.mcap");
  const auto text = bytes_of("to be damaged");
  *std::search(bytes.begin(), bytes.end(), text.begin(), text.end()) = std::byte{'T'};
  testing::write_file(folder / "a.mcap", bytes);
  Reader reader(folder / "a.mcap");
  reader.select([](const Channel& channel) { return channel.topic == "/second"; });
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.damage().chunks_lost, 0U);
  reader.select([](const Channel&) { return true; });
  EXPECT_EQ(read_all(reader).size(), 1U);
  EXPECT_EQ(reader.damage().chunks_lost, 1U);
}

struct Sent {
  std::uint16_t channel = 0;
  std::uint64_t time = 0;
  Bytes data;
};

std::vector<Sent> random_messages(std::uint16_t channels) {
  const auto count = *rc::gen::inRange<std::size_t>(0, 80);
  std::vector<Sent> messages;
  for (std::size_t i = 0; i < count; ++i) {
    // Few different times, so that many are equal.
    messages.push_back({*rc::gen::inRange<std::uint16_t>(0, channels),
                        *rc::gen::inRange<std::uint64_t>(0, 50),
                        bytes_of(*rc::gen::arbitrary<std::string>())});
  }
  return messages;
}

RC_GTEST_PROP(McapRoundTripProperty, AnyMessagesComeBackInOrderOfTime, ()) {
  const TemporaryFolder folder;
  const auto channels = *rc::gen::inRange<std::uint16_t>(1, 5);
  const auto metadata = *rc::gen::arbitrary<StringMap>();
  auto sent = random_messages(channels);
  {
    Writer writer(folder / "a.mcap", {.compression = *rc::gen::elementOf(kCompressions),
                                      .chunk_size = *rc::gen::inRange<std::size_t>(1, 1000),
                                      .chunk_duration = *rc::gen::inRange<std::uint64_t>(0, 60)});
    for (std::uint16_t i = 0; i < channels; ++i) {
      const auto schema = i % 2 == 0 ? writer.add_schema(std::to_string(i), "x", {}) : std::uint16_t{0};
      writer.add_channel(fmt::format("/{}", i), "x", schema, metadata);
    }
    for (const Sent& message : sent) {
      writer.write(message.channel, message.time, 2 * message.time, message.data);
    }
    writer.write(Metadata{"m", metadata});
    writer.close();
  }
  Reader reader(folder / "a.mcap");
  RC_ASSERT(reader.channels().size() == channels);
  RC_ASSERT(reader.channels().at(0).metadata == metadata);
  RC_ASSERT(reader.metadata().at(0).metadata == metadata);
  const auto received = read_all(reader);
  std::stable_sort(sent.begin(), sent.end(), [](const Sent& a, const Sent& b) { return a.time < b.time; });
  RC_ASSERT(received.size() == sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    RC_ASSERT(received[i].channel_id == sent[i].channel);
    RC_ASSERT(received[i].log_time == sent[i].time);
    RC_ASSERT(received[i].publish_time == 2 * sent[i].time);
    RC_ASSERT(received[i].data == sent[i].data);
  }
  RC_ASSERT(!reader.damage().any);
}

}  // namespace
}  // namespace lanefuse::mcap
