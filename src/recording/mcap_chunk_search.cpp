// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_chunk_search.hpp"

#include <algorithm>

#include "recording/mcap_block.hpp"
#include "recording/mcap_cursor.hpp"
#include "recording/mcap_parse.hpp"

namespace lanefuse::mcap {
namespace {

constexpr std::uint64_t kPiece = 1 << 20;
// Record head, two times, size, CRC, compression (up to four letters), and the length of the records.
constexpr std::uint64_t kLongestHead = kRecordHeadSize + 28 + 4 + 4 + 8;
// What looks like a chunk and is none costs time; a file made of nothing else must not take for ever.
constexpr int kMaxFailures = 1000;

// Whether `bytes` begin as a chunk with a CRC, of some plausible size, does.
bool looks_like_chunk(std::span<const std::byte> bytes, std::uint64_t left) {
  Cursor in(bytes);
  const bool is_chunk = in.integer<std::uint8_t>() == static_cast<std::uint8_t>(Opcode::chunk);
  const auto length = in.integer<std::uint64_t>();
  if (!is_chunk || length > kMaxRecord || length > left - std::min(left, kRecordHeadSize)) {
    return false;
  }
  in.take(2 * sizeof(std::uint64_t));
  const bool has_size = in.integer<std::uint64_t>() <= kMaxChunk;
  const bool has_crc = in.integer<std::uint32_t>() != 0;
  const std::string compression = in.text();
  const auto packed = in.integer<std::uint64_t>();
  const bool known = compression.empty() || compression == "lz4" || compression == "zstd";
  return in.ok() && has_size && has_crc && known && packed < length;
}

}  // namespace

std::optional<RecordHead> find_chunk(const InputFile& file, std::uint64_t begin) {
  int failures = 0;
  for (std::uint64_t piece = begin; piece < file.size(); piece += kPiece) {
    const Bytes bytes = file.read(piece, kPiece + kLongestHead);
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(kPiece, bytes.size()); ++i) {
      const std::uint64_t offset = piece + i;
      if (!looks_like_chunk(std::span(bytes).subspan(i), file.size() - offset)) {
        continue;
      }
      const auto head = file.record_head(offset);
      if (head && load_chunk(file, *head).problem.empty()) {
        return head;
      }
      if (++failures > kMaxFailures) {
        return std::nullopt;
      }
    }
  }
  return std::nullopt;
}

}  // namespace lanefuse::mcap
