// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Files made by hand that a reader must refuse, or must not trust.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "recording/mcap_crc32.hpp"
#include "recording/mcap_encode.hpp"
#include "recording/mcap_format.hpp"
#include "recording/mcap_samples.hpp"
#include "support/files.hpp"

namespace lanefuse::mcap {
namespace {

using lanefuse::testing::TemporaryFolder;
using lanefuse::testing::write_file;

void expect_refused(const Bytes& bytes, const std::string& expected) {
  const TemporaryFolder folder;
  write_file(folder / "a.mcap", bytes);
  try {
    Reader reader(folder / "a.mcap");
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("a.mcap"), std::string::npos) << error.what();
  }
}

TEST(McapRefusal, NamesWhatTheFileIsNot) {
  expect_refused({}, "byte 0: this is not an MCAP file");
  expect_refused(bytes_of("solid fuel, no MCAP"), "byte 0: this is not an MCAP file");
  expect_refused(bytes_of("\x89MCAP1\r\n and more"), "byte 5: the MCAP major version 0x31 is not known");
  expect_refused(bytes_of("\x89MCAP0\r\n"), "nothing in it can be read");
  EXPECT_THROW(Reader("/nonexistent/a.mcap"), Error);
  EXPECT_THROW(Reader("/"), Error);
}

// A chunk that says it unpacks to `claimed` bytes.
Bytes file_with_chunk(std::uint64_t claimed, const std::string& compression) {
  Bytes bytes(kMagic.begin(), kMagic.end());
  append(bytes, Header{});
  append(bytes, Metadata{"something to read", {}});
  const Bytes packed = bytes_of("sixteen bytes ..");
  append(bytes, Chunk{0, 0, claimed, 0, compression, packed});
  append(bytes, DataEnd{});
  append(bytes, Footer{});
  bytes.insert(bytes.end(), kMagic.begin(), kMagic.end());
  return bytes;
}

TEST(McapLimits, ChunksThatWouldFillTheMemoryAreNotUnpacked) {
  const TemporaryFolder folder;
  const auto place_of = [&folder](const Bytes& bytes) {
    write_file(folder / "a.mcap", bytes);
    Reader reader(folder / "a.mcap");
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.damage().chunks_lost, 1U);
    return reader.damage().first_place;
  };
  EXPECT_NE(place_of(file_with_chunk(std::uint64_t{1} << 62, "zstd")).find("is the limit"),
            std::string::npos);
  EXPECT_NE(place_of(file_with_chunk(200'000'000, "lz4")).find("more than 1000-fold"), std::string::npos);
  EXPECT_NE(place_of(file_with_chunk(16, "rot13")).find("compression 'rot13'"), std::string::npos);
}

TEST(McapLooseMessages, AreBelievedBesideChunksOnlyWithACrc) {
  const TemporaryFolder folder;
  const auto count = [&folder](std::uint32_t crc) {
    Bytes chunked;
    append(chunked, Channel{1, 0, "/a", "text", {}});
    append(chunked, Message{1, 0, 7, 7, bytes_of("in the chunk")});
    Bytes bytes(kMagic.begin(), kMagic.end());
    append(bytes, Header{});
    append(bytes, Message{1, 0, 9, 9, bytes_of("loose")});
    append(bytes, Chunk{7, 7, chunked.size(), crc32(chunked), "", chunked});
    append(bytes, DataEnd{crc == 0 ? 0 : crc32(bytes) + crc - 1});
    append(bytes, Footer{});
    bytes.insert(bytes.end(), kMagic.begin(), kMagic.end());
    write_file(folder / "a.mcap", bytes);
    Reader reader(folder / "a.mcap");
    const auto messages = read_all(reader);
    EXPECT_EQ(reader.damage().any, messages.size() < 2);
    return messages.size();
  };
  EXPECT_EQ(count(0), 2U);  // absent
  EXPECT_EQ(count(1), 2U);  // right
  EXPECT_EQ(count(2), 1U);  // wrong
}

TEST(McapUnknownRecords, AreSkipped) {
  Bytes bytes(kMagic.begin(), kMagic.end());
  append(bytes, Header{"p", "l"});
  append(bytes, Channel{3, 0, "/a", "text", {}});
  append(bytes, Metadata{"private", {}});
  bytes[kMagic.size() + kRecordHeadSize + 10 + kRecordHeadSize + 22] = std::byte{0x80};
  append(bytes, Message{3, 0, 5, 5, bytes_of("x")});
  append(bytes, DataEnd{});
  append(bytes, Footer{});
  bytes.insert(bytes.end(), kMagic.begin(), kMagic.end());
  const TemporaryFolder folder;
  write_file(folder / "a.mcap", bytes);
  Reader reader(folder / "a.mcap");
  EXPECT_EQ(read_all(reader).size(), 1U);
  EXPECT_TRUE(reader.metadata().empty());
  EXPECT_FALSE(reader.damage().any) << reader.damage().first_place;
}

}  // namespace
}  // namespace lanefuse::mcap
