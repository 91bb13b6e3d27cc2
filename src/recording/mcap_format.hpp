// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lanefuse::mcap {

/// What a record is: the first byte of it. Others than these are skipped, as the specification asks.
enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// First and last bytes of a file; the sixth is the major version.
inline constexpr std::array<std::byte, 8> kMagic{std::byte{0x89}, std::byte{'M'}, std::byte{'C'},
                                                 std::byte{'A'},  std::byte{'P'}, std::byte{'0'},
                                                 std::byte{'\r'}, std::byte{'\n'}};
inline constexpr std::size_t kVersionByte = 5;

inline constexpr std::uint64_t kRecordHeadSize = 9;    ///< opcode and length of the content
inline constexpr std::uint64_t kMessageHeadSize = 22;  ///< content of a message before its data
inline constexpr std::uint64_t kFooterSize = 29;  ///< the whole record, as every writer of version 0 makes it

/// Limits of what is believed: checked before memory is taken.
inline constexpr std::uint64_t kMaxRecord = std::uint64_t{64} << 20;
inline constexpr std::uint64_t kMaxChunk = std::uint64_t{256} << 20;  ///< uncompressed
inline constexpr std::uint64_t kMaxCompressionRatio = 1000;
inline constexpr std::uint64_t kMaxMapEntries = 65'536;
/// Schemas, channels, metadata and attachment names of a file are kept in memory: so many bytes of them in
/// all.
inline constexpr std::uint64_t kMaxDescriptions = std::uint64_t{8} << 20;
inline constexpr std::uint64_t kMaxSummary = std::uint64_t{64} << 20;
/// Pieces of a file (chunks, or runs of messages outside chunks) that the reader keeps account of.
inline constexpr std::uint64_t kMaxBlocks = std::uint64_t{1} << 19;

}  // namespace lanefuse::mcap
