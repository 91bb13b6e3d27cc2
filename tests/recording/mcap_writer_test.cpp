// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "recording/mcap_samples.hpp"
#include "support/files.hpp"

namespace lanefuse::mcap {
namespace {

namespace fs = std::filesystem;
using lanefuse::testing::TemporaryFolder;

std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), {}));
}

TEST(McapWriter, WithoutCloseTheOldFileStaysAndNothingElse) {
  const TemporaryFolder folder;
  testing::write_file(folder / "a.mcap", bytes_of("old"));
  {
    Writer writer(folder / "a.mcap");
    const auto channel = writer.add_channel("/a", "text", 0);
    writer.write(channel, 1, 1, bytes_of("new"));
    EXPECT_TRUE(fs::exists(folder / "a.mcap.part"));
  }
  EXPECT_EQ(testing::read_file(folder / "a.mcap"), bytes_of("old"));
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(McapWriter, CloseReplacesTheOldFile) {
  const TemporaryFolder folder;
  testing::write_file(folder / "a.mcap", bytes_of("old"));
  write_sample(folder / "a.mcap", 3, {});
  EXPECT_EQ(read_all(folder / "a.mcap").size(), 3U);
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(McapWriter, FullDiskIsAnError) {
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP() << "this system has no /dev/full";
  }
  try {
    write_sample("/dev/full", 10, {});
    FAIL() << "a full disk was not noticed";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    EXPECT_NE(std::string(error.what()).find("/dev/full: cannot be written"), std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists("/dev/full.part"));
}

TEST(McapWriter, MissingFolderIsAnErrorThatNamesTheFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(Writer(folder / "missing" / "a.mcap"), Error);
}

TEST(McapWriter, ImpossibleChunkSizeIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(Writer(folder / "a.mcap", {.chunk_size = 0}), Error);
  EXPECT_THROW(Writer(folder / "a.mcap", {.chunk_size = std::size_t{1} << 30}), Error);
  EXPECT_EQ(files_in(folder), 0U);
}

TEST(McapWriter, MessagesThatNoReaderWouldTakeAreRefused) {
  const TemporaryFolder folder;
  Writer writer(folder / "a.mcap");
  const auto channel = writer.add_channel("/a", "text", 0);
  EXPECT_THROW(writer.write(channel, 0, 0, Bytes((std::size_t{32} << 20) + 1)), Error);
}

TEST(McapWriter, KilledWriterLeavesWhatAReaderCanUse) {
  const TemporaryFolder folder;
  Writer writer(folder / "a.mcap", {.chunk_duration = 10});
  const auto channel = writer.add_channel("/a", "text", 0);
  for (std::uint64_t time = 0; time < 100; ++time) {
    writer.write(channel, time, time, bytes_of("x"));
  }
  Reader reader((folder / "a.mcap.part"));
  EXPECT_EQ(read_all(reader).size(), 99U);
  EXPECT_TRUE(reader.damage().any);
}

// The MCAP project's own library is the judge of what is written.
class McapNpm : public ::testing::TestWithParam<Compression> {};

TEST_P(McapNpm, ReadsTheFileWithEveryCrcChecked) {
  const fs::path judge = fs::path(LANEFUSE_SOURCE_DIR) / "tests/npm";
  if (!fs::exists(judge / "node_modules") || std::system("node --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "this test needs node and, in tests/npm, npm ci";
  }
  const TemporaryFolder folder;
  write_sample(folder / "a.mcap", 500, {.compression = GetParam(), .chunk_size = 4000});
  const std::string command = "node '" + (judge / "check_mcap.mjs").string() + "' '" +
                              (folder / "a.mcap").string() + "' > '" + (folder / "out.json").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  nlohmann::json found;
  std::ifstream(folder / "out.json") >> found;
  EXPECT_EQ(found["messages"], 500);
  EXPECT_GT(found["chunks"], 3);
  EXPECT_EQ(found["topics"], nlohmann::json({"/even", "/odd"}));
  EXPECT_EQ(found["schemas"], nlohmann::json::array({"test.Text"}));
  EXPECT_EQ(found["metadata"], nlohmann::json::array({"about"}));
  EXPECT_EQ(found["attachments"], 1);
}

INSTANTIATE_TEST_SUITE_P(Compressions, McapNpm,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

}  // namespace
}  // namespace lanefuse::mcap
