// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
//
// Altered and truncated files: nothing crashes, nothing is lost in silence, and what is sound is given.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.hpp"
#include "recording/mcap_format.hpp"
#include "recording/mcap_input_file.hpp"
#include "recording/mcap_samples.hpp"
#include "support/files.hpp"

namespace lanefuse::mcap {
namespace {

using lanefuse::testing::read_file;
using lanefuse::testing::TemporaryFolder;
using lanefuse::testing::write_file;

constexpr int kCount = 20;

class McapDamage : public ::testing::TestWithParam<Compression> {
 protected:
  McapDamage() {
    write_sample(path_, kCount, {.compression = GetParam(), .chunk_size = 250});
    sound_ = read_file(path_);
    messages_ = read_all(path_);
  }

  struct Outcome {
    std::vector<Message> messages;
    Damage damage;
    bool refused = false;
  };

  Outcome read(const Bytes& bytes) {
    write_file(path_, bytes);
    try {
      Reader reader(path_);
      auto messages = read_all(reader);
      return {std::move(messages), reader.damage(), false};
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::input);
      EXPECT_NE(std::string(error.what()).find("byte "), std::string::npos) << error.what();
      return {{}, {}, true};
    }
  }

  // Where the chunks begin and end.
  std::vector<RecordHead> chunks() {
    write_file(path_, sound_);
    const InputFile file(path_);
    std::vector<RecordHead> chunks;
    for (auto head = file.record_head(kMagic.size()); head && head->opcode != Opcode::data_end;
         head = file.record_head(head->end())) {
      if (head->opcode == Opcode::chunk) {
        chunks.push_back(*head);
      }
    }
    return chunks;
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "a.mcap";
  Bytes sound_;
  std::vector<Message> messages_;
};

TEST_P(McapDamage, EveryTruncationGivesAllWholeChunksBeforeIt) {
  const auto all_chunks = chunks();
  ASSERT_GT(all_chunks.size(), 3U);
  std::size_t last_count = 0;
  for (std::size_t length = 0; length < sound_.size(); ++length) {
    const Outcome outcome = read(Bytes(sound_.begin(), sound_.begin() + static_cast<std::ptrdiff_t>(length)));
    ASSERT_TRUE(outcome.refused || outcome.damage.any) << length;
    ASSERT_LE(outcome.messages.size(), messages_.size());
    ASSERT_TRUE(std::equal(outcome.messages.begin(), outcome.messages.end(), messages_.begin())) << length;
    ASSERT_GE(outcome.messages.size(), last_count) << length;
    last_count = outcome.messages.size();
    if (length >= all_chunks.back().end()) {
      ASSERT_EQ(outcome.messages.size(), messages_.size()) << length;
    }
  }
}

TEST_P(McapDamage, OneAlteredChunkCostsOnlyItself) {
  const auto all_chunks = chunks();
  for (const RecordHead& chunk : all_chunks) {
    Bytes bytes = sound_;
    bytes[chunk.end() - 5] ^= std::byte{0x10};
    const Outcome outcome = read(bytes);
    EXPECT_EQ(outcome.damage.chunks_lost, 1U);
    EXPECT_EQ(outcome.damage.first_byte, chunk.offset);
    EXPECT_LT(outcome.messages.size(), messages_.size());
    EXPECT_GT(outcome.messages.size(), messages_.size() * 3 / 5);
    EXPECT_TRUE(std::includes(messages_.begin(), messages_.end(), outcome.messages.begin(),
                              outcome.messages.end(),
                              [](const Message& a, const Message& b) { return a.log_time < b.log_time; }));
  }
}

TEST_P(McapDamage, AlteredLengthOfAChunkIsSurvived) {
  const auto all_chunks = chunks();
  const RecordHead chunk = all_chunks[1];
  for (const std::size_t byte : {1U, 2U, 4U, 7U, 8U}) {
    Bytes bytes = sound_;
    bytes[chunk.offset + byte] ^= std::byte{0x7f};
    const Outcome with_index = read(bytes);
    EXPECT_EQ(with_index.messages, messages_) << byte;  // the index knows better
    EXPECT_TRUE(with_index.damage.any);

    bytes.resize(bytes.size() - 1);  // no footer any more, so no index
    const Outcome without_index = read(bytes);
    EXPECT_GE(without_index.messages.size(), messages_.size() / 2) << byte;
    EXPECT_EQ(without_index.messages.back(), messages_.back()) << byte;
    EXPECT_TRUE(without_index.damage.any);
  }
}

TEST_P(McapDamage, AlteredSummaryIsReplacedByScanning) {
  Bytes bytes = sound_;
  bytes[bytes.size() - 60] ^= std::byte{1};
  const Outcome outcome = read(bytes);
  EXPECT_EQ(outcome.messages, messages_);
  EXPECT_NE(outcome.damage.first_place.find("the summary's CRC does not match"), std::string::npos);
}

TEST_P(McapDamage, EverySingleAlteredBitIsNoticed) {
  for (std::size_t byte = 0; byte < sound_.size(); ++byte) {
    for (const unsigned bit : {0U, 1U, 3U, 7U}) {
      Bytes bytes = sound_;
      bytes[byte] ^= static_cast<std::byte>(1U << bit);
      const Outcome outcome = read(bytes);
      ASSERT_TRUE(outcome.refused || outcome.damage.any) << byte << " bit " << bit;
      for (const Message& message : outcome.messages) {
        ASSERT_TRUE(std::find(messages_.begin(), messages_.end(), message) != messages_.end()) << byte;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Compressions, McapDamage,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

RC_GTEST_PROP(McapDamageProperty, ManyAlteredBytesNeverGiveAForeignMessage, ()) {
  const TemporaryFolder folder;
  const auto path = folder / "a.mcap";
  write_sample(path, kCount, {.compression = Compression::lz4, .chunk_size = 250});
  const auto messages = read_all(path);
  Bytes bytes = read_file(path);
  const auto flips = *rc::gen::inRange(1, 20);
  for (int i = 0; i < flips; ++i) {
    // The magic is not what is tested here.
    const auto byte = *rc::gen::inRange<std::size_t>(kMagic.size(), bytes.size());
    bytes[byte] =
        *rc::gen::map(rc::gen::inRange(0, 256), [](int value) { return static_cast<std::byte>(value); });
  }
  bytes.resize(*rc::gen::inRange<std::size_t>(kMagic.size(), bytes.size() + 1));
  write_file(path, bytes);
  try {
    for (const Message& message : read_all(path)) {
      RC_ASSERT(std::find(messages.begin(), messages.end(), message) != messages.end());
    }
  } catch (const Error& error) {
    RC_ASSERT(error.kind() == Error::Kind::input);
  }
}

}  // namespace
}  // namespace lanefuse::mcap
