// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "recording/mcap_block.hpp"

#include <fmt/format.h>

#include "recording/mcap_compression.hpp"
#include "recording/mcap_crc32.hpp"
#include "recording/mcap_parse.hpp"

namespace lanefuse::mcap {
namespace {

// Why a chunk's lengths cannot be believed; empty if they can.
std::string size_problem(const Chunk& chunk) {
  if (chunk.uncompressed_size > kMaxChunk) {
    return fmt::format("the chunk would unpack to {} bytes, and {} is the limit", chunk.uncompressed_size,
                       kMaxChunk);
  }
  if (chunk.uncompressed_size / kMaxCompressionRatio > chunk.records.size()) {
    return fmt::format("the chunk would unpack {} bytes to {}, more than 1000-fold", chunk.records.size(),
                       chunk.uncompressed_size);
  }
  return {};
}

LoadedBlock unpack(const Chunk& chunk) {
  if (std::string problem = size_problem(chunk); !problem.empty()) {
    return {{}, std::move(problem)};
  }
  auto records = decompress(chunk.compression, chunk.records, chunk.uncompressed_size);
  if (!records) {
    return {{},
            fmt::format("the chunk cannot be unpacked (compression '{}')", chunk.compression.substr(0, 16))};
  }
  if (chunk.uncompressed_crc != 0 && crc32(*records) != chunk.uncompressed_crc) {
    return {{}, "the chunk's CRC does not match"};
  }
  return {std::move(*records), {}};
}

}  // namespace

LoadedBlock load_chunk(const InputFile& file, const RecordHead& head) {
  if (head.size > kMaxRecord) {
    return {{}, fmt::format("the chunk has {} bytes, and {} is the limit", head.size, kMaxRecord)};
  }
  const Bytes content = file.content(head);
  const auto chunk = parse<Chunk>(content);
  return chunk ? unpack(*chunk) : LoadedBlock{{}, "the chunk's lengths contradict each other"};
}

LoadedBlock load_block(const InputFile& file, const Block& block) {
  LoadedBlock loaded;
  if (block.is_chunk) {
    loaded = load_chunk(file, {Opcode::chunk, block.offset, block.length - kRecordHeadSize});
  } else {
    loaded.records = file.read(block.offset, block.length);
  }
  if (loaded.problem.empty() && loaded.records.size() != block.size) {
    return {{}, "the chunk's size is not the one in the index"};
  }
  return loaded;
}

}  // namespace lanefuse::mcap
